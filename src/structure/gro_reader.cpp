// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "structure/gro_reader.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/largest_length.h"
#include "radii/aliases.h"
#include "reading/numbers.h"
#include "reading/text.h"
#include "structure/choose_atoms.h"
#include "structure/element.h"
#include "structure/simulated_atoms.h"

namespace meniscus::reading {
namespace {

// Number and name of the residue, name and number of the atom have five columns each; then come the coordinates, whose
// first point stands in column 25 whatever their width.
constexpr std::size_t kNameWidth = 5;
constexpr std::size_t kFirstCoordinate = 4 * kNameWidth;
constexpr std::size_t kFirstPoint = 24;
constexpr std::size_t kBeforePoint = 5;  // columns of a coordinate up to its point
constexpr std::size_t kLeastWidth = kBeforePoint + 1;
constexpr std::size_t kLargestWidth = kBeforePoint + 20;

std::string_view columns(std::string_view line, std::size_t first, std::size_t width) {
    return first < line.size() ? line.substr(first, width) : std::string_view();
}

// How far the points of x, y and z are apart, if they stand where they belong.
std::optional<std::size_t> coordinate_width(std::string_view line) {
    const std::size_t x = line.find('.', kFirstCoordinate);
    const std::size_t y = x == std::string_view::npos ? x : line.find('.', x + 1);
    const std::size_t z = y == std::string_view::npos ? y : line.find('.', y + 1);
    if (x != kFirstPoint || z == std::string_view::npos || z - y != y - x) return std::nullopt;
    return y - x >= kLeastWidth && y - x <= kLargestWidth ? std::optional(y - x) : std::nullopt;
}

bool is_atom_line(std::string_view line) {
    const std::optional<std::size_t> width = coordinate_width(line);
    return width && line.size() >= kFirstCoordinate + 3 * *width && integer(columns(line, 0, kNameWidth));
}

// Walks from frame to frame.
class FrameFinder {
public:
    FrameFinder(std::string_view text, const std::string& file) : text_(text), lines_(text), file_(file) {}

    std::vector<GroFrame> run() {
        do frames_.push_back(frame());
        while (!is_blank_line_to_end());
        return std::move(frames_);
    }

private:
    GroFrame frame() {
        next("the title");
        next("the number of atoms");
        const std::optional<int> count = integer(lines_.line());
        if (!count || *count < 0)
            fail("the second line of a frame is the number of its atoms, not " + shown(lines_.line()) + "; correct it");
        GroFrame frame{lines_.end(), lines_.number() + 1, static_cast<std::size_t>(*count)};
        for (std::size_t i = 0; i < frame.atoms; ++i) skip_atom(frame, i);
        read_box(frame);
        return frame;
    }

    void skip_atom(GroFrame& frame, std::size_t i) {
        if (!lines_.next())
            fail_at(file_, {lines_.number() + 1, 1},
                    "the file ends after " + std::to_string(i) + " of " + counted(frame.atoms, "atom") +
                        "; fetch or write it again");
        if (i == 0) frame.width = width();
    }

    std::size_t width() const {
        if (const std::optional<std::size_t> width = coordinate_width(lines_.line())) return *width;
        fail(
            "no three coordinates with their points at equal distances from column 25 on; write the columns of "
            "GROMACS, or convert the file to PDB");
    }

    void read_box(const GroFrame& frame) {
        next("the box");
        const std::string_view line = lines_.line();
        if (is_atom_line(line))
            fail("another atom behind " + counted(frame.atoms, "atom") + ", the number on line " +
                 std::to_string(frame.first_line - 1) + "; correct that number");
        Words words(line);
        for (int i = 0; i < 3; ++i) {
            if (!finite_number(words.next()))
                fail("the box needs three lengths, not " + shown(trimmed(line)) + "; correct it");
        }
    }

    void next(const char* what) {
        if (lines_.next()) return;
        fail_at(file_, {lines_.number() + 1, 1},
                std::string("the line of ") + what + " is missing; fetch or write the file again");
    }

    bool is_blank_line_to_end() const {
        return text_.find_first_not_of(" \t\n", std::min(lines_.end(), text_.size())) == std::string_view::npos;
    }

    [[noreturn]] void fail(const std::string& message) const { fail_at(file_, {lines_.number(), 1}, message); }

    std::string_view text_;
    Lines lines_;
    const std::string& file_;
    std::vector<GroFrame> frames_;
};

// One line of an atom.
class GroLine {
public:
    struct Form {
        std::size_t number;  // of the line
        std::size_t width;   // of a coordinate
    };

    GroLine(std::string_view line, const Form& form, const std::string& file)
        : line_(line), number_(form.number), width_(form.width), file_(file) {
        if (line_.size() < kFirstCoordinate + 3 * width_)
            fail(line_.size(), "the line ends before column " + std::to_string(kFirstCoordinate + 3 * width_) +
                                   ", the last of z; correct it");
    }

    int residue_number() const {
        const std::string_view text = columns(line_, 0, kNameWidth);
        const std::optional<int> number = integer(text);
        if (!number) fail(0, "residue number " + shown(text) + " is not an integer; correct it");
        return *number;
    }

    std::string residue_name() const { return name(kNameWidth, "residue"); }
    std::string atom_name() const { return name(2 * kNameWidth, "atom"); }

    // None where there are more atoms than five columns count and the program wrote something else.
    std::optional<int> serial() const { return integer(columns(line_, 3 * kNameWidth, kNameWidth)); }

    Vec3 centre() const { return {coordinate(0, "x"), coordinate(1, "y"), coordinate(2, "z")}; }

private:
    std::string name(std::size_t first, const char* of) const {
        const std::string_view text = trimmed(columns(line_, first, kNameWidth));
        if (text.empty()) fail(first, std::string("the name of the ") + of + " is missing; correct it");
        if (find_unprintable(text) == std::string_view::npos) return upper_case(text);
        fail(first, "a byte that is not a printable character in the name " + shown(text) + "; correct it");
    }

    // Å. The digits as a whole number over a power of ten: as near to it as a PDB file's number.
    double coordinate(std::size_t axis, const char* name) const {
        constexpr std::size_t kFewDecimals = 10;
        constexpr double kLargestWhole = 9e15;
        const std::size_t first = kFirstCoordinate + axis * width_;
        const std::string_view text = columns(line_, first, width_);
        const std::optional<double> value = finite_number(text);
        if (!value || std::abs(*value) > kLargestLength)
            fail(first, std::string(name) + " coordinate " + shown(text) + " is not a finite number; correct it");
        const std::size_t decimals = width_ - kBeforePoint;
        const double power = std::pow(10.0, static_cast<double>(decimals) - 1.0);
        const double whole = std::round(*value * 10.0 * power);
        return decimals <= kFewDecimals && std::abs(whole) < kLargestWhole ? whole / power : 10.0 * *value;
    }

    [[noreturn]] void fail(std::size_t at, const std::string& message) const {
        fail_at(file_, {number_, at + 1}, message);
    }

    std::string_view line_;
    std::size_t number_;
    std::size_t width_;
    const std::string& file_;
};

RawAtom to_gro_atom(const GroLine& line, const RawResidue& residue) {
    RawAtom atom;
    atom.centre = line.centre();
    atom.name = line.atom_name();
    atom.element = element_from_name(atom.name, residue.name);
    atom.guessed_element = true;
    atom.hetatm = !is_standard_name(residue.name);
    return atom;
}

// Atoms of a frame and the residues that they make.
class FrameReader {
public:
    FrameReader(const GroFrame& frame, const std::string& file) : frame_(frame), file_(file) {
        model_.why_guessed = "GROMACS files have no elements";
        model_.atoms.reserve(frame.atoms);
    }

    RawModel run(std::string_view text) {
        Lines lines(text.substr(std::min(frame_.begin, text.size())));
        for (std::size_t i = 0; i < frame_.atoms && lines.next(); ++i)
            read(GroLine(lines.line(), {frame_.first_line + i, frame_.width}, file_), i);
        finish();
        return std::move(model_);
    }

private:
    void read(const GroLine& line, std::size_t i) {
        const int number = line.residue_number();
        const std::string name = line.residue_name();
        if (is_site_of_water(line.atom_name(), name)) {
            ++virtual_sites_;
            return;
        }
        if (!is_of_last_residue(line, number, name)) add_residue(number, name);
        model_.atoms.push_back(to_gro_atom(line, model_.residues.back()));
        model_.atoms.back().residue = static_cast<std::uint32_t>(model_.residues.size() - 1);
        model_.atoms.back().serial = line.serial().value_or(static_cast<int>(i + 1));
    }

    // Of amino acids, nucleotides and waters the first atom comes a second time where the next one of the same number
    // begins: of another chain, or of another insertion code, both of which the format leaves out.
    bool is_of_last_residue(const GroLine& line, int number, const std::string& name) const {
        if (model_.residues.empty()) return false;
        const RawResidue& last = model_.residues.back();
        if (last.number != number || last.name != name) return false;
        return !is_standard_name(name) || model_.atoms[first_of_residue_].name != line.atom_name();
    }

    void add_residue(int number, const std::string& name) {
        RawResidue& residue = model_.residues.emplace_back();
        residue.number = number;
        residue.name = name;
        first_of_residue_ = model_.atoms.size();
    }

    void finish() {
        tell_virtual_sites(virtual_sites_, model_);
        tell_hetero_by_name("GROMACS files do", model_);
    }

    const GroFrame& frame_;
    const std::string& file_;
    RawModel model_;
    std::size_t first_of_residue_ = 0;  // an atom
    std::size_t virtual_sites_ = 0;
};

}  // namespace

bool is_gro(std::string_view text) {
    Lines lines(text);
    if (!lines.next() || !lines.next() || !integer(lines.line())) return false;
    return lines.next() && is_atom_line(lines.line());
}

std::vector<GroFrame> find_gro_frames(std::string_view text, const std::string& file) {
    return FrameFinder(text, file).run();
}

RawModel parse_gro(std::string_view text, const GroFrame& frame, const std::string& file) {
    return FrameReader(frame, file).run(text);
}

}  // namespace meniscus::reading
