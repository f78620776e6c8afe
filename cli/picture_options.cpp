// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "picture_options.h"

#include <fmt/core.h>

#include <nlohmann/json.hpp>

#include "help.h"
#include "meniscus/file_words.h"
#include "meniscus/page.h"
#include "meniscus/vertex_values.h"
#include "option_words.h"

namespace meniscus::cli {

using nlohmann::ordered_json;

namespace {

/// From the molecule towards the viewer, in the frame of the input.
struct NamedView {
    const char* name;
    Viewpoint viewpoint;
};
constexpr std::array kViews{
    NamedView{"front", {{0, 0, 1}, {0, 1, 0}}}, NamedView{"back", {{0, 0, -1}, {0, 1, 0}}},
    NamedView{"left", {{-1, 0, 0}, {0, 1, 0}}}, NamedView{"right", {{1, 0, 0}, {0, 1, 0}}},
    NamedView{"top", {{0, 1, 0}, {0, 0, -1}}},  NamedView{"bottom", {{0, -1, 0}, {0, 0, 1}}},
};
/// What is drawn beside the surface: whether ligands are.
constexpr Words<bool, 2> kDrawWords{{{"ligands", true}, {"none", false}}};

/// Width and height, pixels; in half of it every legend has room.
constexpr std::array kSmallestWithLegend{320, 240};

constexpr const char* kViewWords = "auto, front, back, left, right, top, bottom, or X,Y,Z[:UX,UY,UZ]";

std::vector<std::string> split(const std::string& text, char separator) {
    return text.empty() ? std::vector<std::string>{""} : CLI::detail::split(text, separator);
}

ColourOptions parse_colours(const std::string& text) {
    const std::vector<std::string> parts = split(text, ':');
    if (parts.size() != 1 && parts.size() != 3)
        throw UsageError(fmt::format("--color: '{}' is neither a scheme nor SCHEME:MIN:MAX", text));
    const bool is_scheme = is_word_of(kColourSchemeWords, parts[0]);
    if (parts.size() == 1 && !is_scheme)
        if (const auto colour = colour_of_text(text)) return {.scheme = ColourScheme::Single, .colour = colour};
    if (text.starts_with('#'))
        throw UsageError(
            fmt::format("--color: '{}' is not a colour; write six hexadecimal digits, as in '#ff6347'", text));
    const bool of_values = !is_scheme && is_value_name(parts[0]);
    ColourOptions colours{.scheme = ColourScheme::Value};
    if (of_values)
        colours.value = parts[0];
    else
        colours.scheme = parse_word("--color", parts[0], kColourSchemeWords);
    if (parts.size() == 1) return colours;
    if (!takes_range(colours.scheme))
        throw UsageError(fmt::format("--color: {} takes no range; curvature, depth, bfactor and values do", parts[0]));
    colours.range = {parse_number("--color", parts[1], NumberRange::Any),
                     parse_number("--color", parts[2], NumberRange::Any)};
    if (colours.range->min >= colours.range->max)
        throw UsageError(fmt::format("--color: the range of '{}' is empty; write the smaller value first", text));
    return colours;
}

constexpr const char* kCutWords = "none, auto, cavity:N, a depth in Å, or X,Y,Z[:NX,NY,NZ]";

Vec3 parse_vector(const char* option, const std::string& text, const char* words) {
    if (std::count(text.begin(), text.end(), ',') != 2)
        throw UsageError(fmt::format("{}: unknown value '{}'; choose one of {}", option, text, words));
    const std::vector<double> numbers = numbers_in(option, text);
    return {numbers[0], numbers[1], numbers[2]};
}

Vec3 parse_direction(const std::string& text) { return parse_vector("--view", text, kViewWords); }

Cut parse_cut_through_point(const std::string& text) {
    const std::size_t colon = text.find(':');
    Cut cut{.through = Cut::Through::Point, .point = parse_vector("--cut", text.substr(0, colon), kCutWords)};
    if (colon == std::string::npos) return cut;
    cut.normal = parse_vector("--cut", text.substr(colon + 1), kCutWords);
    if (squared_norm(*cut.normal) == 0.0)
        throw UsageError(fmt::format("--cut: '{}' needs a normal that is not zero", text));
    return cut;
}

std::optional<Cut> parse_cut(const std::string& text) {
    constexpr std::string_view kCavity = "cavity:";
    if (text == "none") return std::nullopt;
    if (text == "auto") return Cut{};
    if (text.starts_with(kCavity)) {
        const int number = parse_count("--cut", text.substr(kCavity.size()));
        return Cut{.through = Cut::Through::Cavity, .cavity = static_cast<std::size_t>(number)};
    }
    if (text.find(',') != std::string::npos) return parse_cut_through_point(text);
    if (text.find_first_not_of("0123456789.+-eE") != std::string::npos)
        throw UsageError(fmt::format("--cut: unknown value '{}'; choose one of {}", text, kCutWords));
    return Cut{.through = Cut::Through::Depth, .depth = parse_number("--cut", text, NumberRange::NotNegative)};
}

/// Up is y, or where that is the way one looks, away from the viewer of "front".
Vec3 usual_up(const Vec3& from) {
    return from.x == 0.0 && from.z == 0.0 ? Vec3{0.0, 0.0, std::copysign(1.0, -from.y)} : Vec3{0.0, 1.0, 0.0};
}

Viewpoint parse_viewpoint(const std::string& text) {
    const std::size_t colon = text.find(':');
    const Vec3 from = parse_direction(text.substr(0, colon));
    const Vec3 up = colon == std::string::npos ? usual_up(from) : parse_direction(text.substr(colon + 1));
    if (squared_norm(cross(from, up)) == 0.0)
        throw UsageError(fmt::format("--view: '{}' needs directions that are not zero and not parallel", text));
    return {from, up};
}

std::optional<Viewpoint> parse_view(const std::string& text) {
    if (text == "auto") return std::nullopt;
    const auto found = std::find_if(kViews.begin(), kViews.end(), [&](const NamedView& v) { return text == v.name; });
    return found != kViews.end() ? found->viewpoint : parse_viewpoint(text);
}

int parse_pixels(const std::string& text) {
    const int pixels = parse_count("--size", text);
    if (pixels > kLargestPicture)
        throw UsageError(fmt::format("--size: {} pixels are too many; choose at most {}", pixels, kLargestPicture));
    return pixels;
}

void set_size(PictureOptions& picture, const std::string& text) {
    const std::vector<std::string> parts = split(text, 'x');
    if (parts.size() != 2) throw UsageError(fmt::format("--size: must be WIDTHxHEIGHT in pixels, not '{}'", text));
    picture.width = parse_pixels(parts[0]);
    picture.height = parse_pixels(parts[1]);
}

Colour parse_background(const std::string& text) {
    if (text == "transparent") return kTransparent;
    if (const auto colour = colour_of_text(text)) return *colour;
    throw UsageError(fmt::format(
        "--background: '{}' is not a colour; write transparent, a name of CSS such as white or navy, or six "
        "hexadecimal digits, as in '#ffcc00'",
        text));
}

std::string describe(const Colour& c) {
    return c.alpha == 0 ? "transparent" : fmt::format("#{:02x}{:02x}{:02x}", c.red, c.green, c.blue);
}

/// Notes that an option was given which pictures heed, some also pages.
void note_given(PictureRequest& request, std::string_view name) {
    const bool of_pages = name == "--view" || name == "--perspective";
    if (name == "--draw") {
        request.shown_by = name;
        return;
    }
    (of_pages ? request.viewed_by : request.drawn_by) = name;
}

/// An option that only pictures and pages heed.
template <class Set>
void add_drawing(CLI::App& command, PictureRequest& request, const OptionHelp& help, const Set& set) {
    add_word(command, help, [&request, name = help.name, set](const std::string& value) {
        note_given(request, name);
        set(value);
    });
}

template <class Set>
void add_drawing_flag(CLI::App& command, PictureRequest& request, const OptionHelp& help, const Set& set) {
    const auto read = [&request, name = help.name, set](std::int64_t) {
        note_given(request, name);
        set();
    };
    command.add_flag_function(help.name, read, help.text);
}

void add_colour(CLI::App& command, PictureRequest& request) {
    const std::string text = fmt::format(
        "Colours of pictures, meshes and pages\n: {}; auto: chain if there are several, else single. curvature, depth "
        "and bfactor also as SCHEME:MIN:MAX; or NAME[:MIN:MAX] of values; or one colour by its CSS name, such as "
        "tomato, or as '#rrggbb'",
        join(kColourSchemeWords, ", "));
    add_word(command, {"--color", text, "SCHEME", kColourSchemeWords.front().first},
             [&request](const std::string& value) { request.colours = parse_colours(value); });
}

}  // namespace

void check_picture(const PictureRequest& request) {
    const PictureOptions& picture = request.picture;
    if (request.legend && (picture.width < kSmallestWithLegend[0] || picture.height < kSmallestWithLegend[1]))
        throw UsageError(
            fmt::format("--legend: does not fit into a picture of {}x{} pixels; choose a --size of at least {}x{}",
                        picture.width, picture.height, kSmallestWithLegend[0], kSmallestWithLegend[1]));
}

bool draws_ligands(const std::vector<Output>& outputs) {
    return std::any_of(outputs.begin(), outputs.end(), [](const Output& o) {
        return o.kind == OutputKind::Picture || o.kind == OutputKind::Page || suffix_of(o.path) == ".glb";
    });
}

void check_drawn(const PictureRequest& request, const std::vector<Output>& outputs) {
    const auto has = [&](OutputKind kind) {
        return std::any_of(outputs.begin(), outputs.end(), [kind](const Output& o) { return o.kind == kind; });
    };
    const bool has_page = has(OutputKind::Page);
    const bool has_picture = has(OutputKind::Picture);
    if (has_page && !pages_supported())
        throw UsageError("this build cannot write pages; build with MENISCUS_PAGE=ON, or ask for another format");
    if (has_picture && !pictures_supported())
        throw UsageError("this build draws no pictures; build with MENISCUS_PICTURES=ON, or ask for another format");
    if (!request.drawn_by.empty() && !has_picture)
        throw UsageError(request.drawn_by + " applies to pictures; ask for one with -o FILE.png");
    if (!request.shown_by.empty() && !draws_ligands(outputs))
        throw UsageError(request.shown_by +
                         " applies to pictures, pages and GLB; ask for one with -o FILE.png, FILE.html or FILE.glb");
    if (!request.viewed_by.empty() && !has_picture && !has_page)
        throw UsageError(request.viewed_by +
                         " applies to pictures and pages; ask for one with -o FILE.png or FILE.html");
}

void add_picture_options(CLI::App& command, PictureRequest& request) {
    add_colour(command, request);
    add_drawing_options(command, request);
}

void add_drawing_options(CLI::App& command, PictureRequest& request) {
    PictureOptions& picture = request.picture;
    add_drawing(command, request,
                {"--view",
                 "Seen from: front, back ... or X,Y,Z\n[:UX,UY,UZ], the directions to the viewer and up; front, back, "
                 "left, right, top, bottom; auto: the longest axis lies across",
                 "VIEW", "auto"},
                [&](const std::string& text) {
                    picture.viewpoint = parse_view(text);
                    request.view = text;
                });
    add_drawing(command, request, {"--size", "Size of pictures, in pixels", "WxH", "1600x1200"},
                [&](const std::string& text) { set_size(picture, text); });
    add_drawing(
        command, request,
        {"--background", "white, black, transparent, #rrggbb\n, or another colour by its CSS name", "COLOR", "white"},
        [&](const std::string& text) { picture.background = parse_background(text); });
    add_drawing(command, request, {"--depth-cue", rarely("Fade distant parts into the background, 0 to 1"), "F", "0"},
                [&](const std::string& text) {
                    picture.depth_cue = parse_number("--depth-cue", text, NumberRange::NotNegative);
                    if (picture.depth_cue > 1.0)
                        throw UsageError(fmt::format("--depth-cue: must be from 0 to 1, not {}", text));
                });
    add_drawing(command, request,
                {"--cut",
                 "Cut by a plane: auto, cavity:N, DEPTH\n"
                 ", X,Y,Z[:NX,NY,NZ]. auto: through the largest cavity; DEPTH: that many Å behind the nearest point; "
                 "X,Y,Z: through this point, with the normal towards the side that is left out",
                 "WHERE", "none"},
                [&](const std::string& text) {
                    picture.cut = parse_cut(text);
                    request.cut = picture.cut ? text : "";
                });
    add_drawing_flag(command, request, {"--perspective", rarely("Draw nearer parts larger")},
                     [&] { picture.projection = Projection::Perspective; });
    add_drawing_flag(command, request, {"--outline", rarely("Draw outlines where the surface ends")},
                     [&] { picture.outline = true; });
    add_drawing(command, request,
                {"--draw",
                 rarely("Draw ligands beside the surface: ligands, none\n, as sticks and balls in pictures, pages and "
                        "GLB: hetero groups but for waters, ions and what crystals are grown from"),
                 "ligands|none", kDrawWords.front().first},
                [&](const std::string& text) { request.ligands = parse_word("--draw", text, kDrawWords); });
    add_drawing_flag(command, request, {"--legend", "Add a legend of the colours"}, [&] { request.legend = true; });
}

ordered_json report_picture(const PictureRequest& request, const Structure& structure, const Mesh& mesh, bool drawn) {
    ordered_json options;
    ColourOptions colours = request.colours;
    colours.scheme = scheme_in_force(colours.scheme, structure);
    const bool of_values = colours.scheme == ColourScheme::Value;
    options["color"] = of_values ? colours.value : word_for(kColourSchemeWords, colours.scheme);
    if (colours.colour) options["color"] = describe(*colours.colour);
    options["color_range"] = nullptr;
    if (takes_range(colours.scheme)) {
        const ValueRange range = range_in_force(colours, mesh, structure);
        options["color_range"] = {range.min, range.max};
    }
    for (const char* name : {"view", "size", "background", "cut", "perspective", "outline", "depth_cue", "legend"})
        options[name] = nullptr;
    options["draw"] = word_for(kDrawWords, request.ligands);
    if (!drawn) return options;
    const PictureOptions& picture = request.picture;
    options["view"] = request.view;
    options["size"] = {picture.width, picture.height};
    options["background"] = describe(picture.background);
    if (picture.cut) options["cut"] = request.cut;
    options["perspective"] = picture.projection == Projection::Perspective;
    options["outline"] = picture.outline;
    options["depth_cue"] = picture.depth_cue;
    options["legend"] = request.legend;
    return options;
}

}  // namespace meniscus::cli
