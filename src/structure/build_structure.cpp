// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "structure/build_structure.h"

#include <algorithm>
#include <functional>
#include <limits>

#include "meniscus/errors.h"
#include "reading/text.h"

namespace meniscus::reading {
namespace {

AtomLabel to_label(const RawAtom& atom, std::uint32_t residue) {
    AtomLabel label;
    label.residue = residue;
    label.name = atom.name;
    label.element = atom.element;
    label.altloc = atom.altloc;
    label.serial = atom.serial;
    label.b_factor = atom.b_factor;
    label.occupancy = atom.occupancy;
    label.charge = atom.charge;
    return label;
}

// Appends copies of kept atoms, and their residues, to a structure.
class Builder {
public:
    Builder(const RawModel& model, const Chosen& chosen, const AssignedRadii& radii, Structure& structure)
        : model_(model), chosen_(chosen), radii_(radii), structure_(structure) {}

    void reserve(std::size_t count) {
        if (count > std::numeric_limits<std::uint32_t>::max()) {
            throw LimitError(structure_.file +
                             ": more than 4294967295 atoms; choose some of the chains, or a selection");
        }
        structure_.atoms.centres.reserve(count);
        structure_.atoms.radii.reserve(count);
        structure_.labels.reserve(count);
    }

    // Copies the kept atoms and the ligands whose residues are wanted.
    template <class Wanted, class ChainName>
    void append(const RawOperator& op, bool moves, Wanted wanted, ChainName chain_name) {
        const auto copy = [&](const std::vector<std::uint32_t>& atoms, auto& to, const auto& take) {
            // Atoms of a residue may stand in several places of the file.
            constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();
            std::vector<std::uint32_t> copies(atoms.empty() ? 0 : model_.residues.size(), kNone);
            for (std::size_t k = 0; k < atoms.size(); ++k) {
                const RawAtom& atom = model_.atoms[atoms[k]];
                if (!wanted(atom.residue)) continue;
                std::uint32_t& number = copies[atom.residue];
                if (number == kNone) number = add_residue(model_.residues[atom.residue], chain_name, to.residues);
                to.labels.push_back(to_label(atom, number));
                take(k, moves ? op.apply(atom.centre) : atom.centre);
            }
        };
        copy(chosen_.atoms, structure_, [&](std::size_t k, const Vec3& centre) {
            structure_.atoms.centres.push_back(centre);
            structure_.atoms.radii.push_back(radii_.values[k]);
        });
        copy(chosen_.ligands_drawn, structure_.ligands,
             [&](std::size_t /*k*/, const Vec3& centre) { structure_.ligands.centres.push_back(centre); });
    }

private:
    template <class ChainName>
    static std::uint32_t add_residue(const RawResidue& residue, ChainName chain_name, std::vector<Residue>& residues) {
        residues.push_back({chain_name(residue.chain), residue.name, residue.number, residue.insertion_code});
        return static_cast<std::uint32_t>(residues.size() - 1);
    }

    const RawModel& model_;
    const Chosen& chosen_;
    const AssignedRadii& radii_;
    Structure& structure_;
};

const RawAssembly& find_assembly(const RawModel& model, const std::string& name, const std::string& file) {
    std::string names;
    for (const RawAssembly& assembly : model.assemblies) {
        if (assembly.name == name) return assembly;
        names += " " + printable(assembly.name);
    }
    throw InputError(file + ": no assembly " + name + "; " +
                     (names.empty() ? "the file has none, ask for no assembly" : "assemblies of the file:" + names));
}

bool is_in(const std::vector<std::string>& names, const std::string& name) {
    return std::find(names.begin(), names.end(), name) != names.end();
}

// For each residue of the model, whether a generator copies it.
std::vector<bool> copied_residues(const RawModel& model, const RawGenerator& generator) {
    std::vector<bool> copied(model.residues.size());
    std::transform(model.residues.begin(), model.residues.end(), copied.begin(), [&](const RawResidue& residue) {
        return is_in(generator.chains, generator.label_names ? residue.label_chain : residue.chain);
    });
    return copied;
}

// Numbers the copies of each chain by the operators applied to it so far: parts of a chain that are moved alike
// (protein and haem of an mmCIF file) stay in one chain.
class CopyNames {
public:
    std::string name(const std::string& chain, const RawOperator& op) {
        std::vector<RawOperator>& seen = operators_[chain];
        auto found = std::find(seen.begin(), seen.end(), op);
        if (found == seen.end()) found = seen.insert(seen.end(), op);
        const auto number = found - seen.begin() + 1;
        return number == 1 ? chain : chain + "-" + std::to_string(number);
    }

private:
    std::map<std::string, std::vector<RawOperator>> operators_;
};

std::size_t count_kept(const RawModel& model, const Chosen& chosen, const std::vector<bool>& copied) {
    return static_cast<std::size_t>(std::count_if(chosen.atoms.begin(), chosen.atoms.end(),
                                                  [&](std::uint32_t i) { return copied[model.atoms[i].residue]; }));
}

void append_assembly(const RawModel& model, const Chosen& chosen, const RawAssembly& assembly, Builder& builder,
                     Structure& structure) {
    std::vector<std::vector<bool>> copied;
    std::vector<bool> in_any(model.residues.size(), false);
    std::size_t count = 0;
    for (const RawGenerator& generator : assembly.generators) {
        if (generator.operators.empty()) {
            throw InputError(structure.file + ": assembly " + assembly.name +
                             " has operators that cannot be read; ask for no assembly");
        }
        copied.push_back(copied_residues(model, generator));
        count += generator.operators.size() * count_kept(model, chosen, copied.back());
        std::transform(in_any.begin(), in_any.end(), copied.back().begin(), in_any.begin(), std::logical_or<>());
    }
    builder.reserve(count);
    CopyNames names;
    for (std::size_t g = 0; g < copied.size(); ++g) {
        for (const RawOperator& op : assembly.generators[g].operators) {
            builder.append(
                op, op != RawOperator{}, [&](std::uint32_t residue) { return copied[g][residue]; },
                [&](const std::string& chain) { return names.name(chain, op); });
        }
    }
    const std::size_t left_out = chosen.atoms.size() - count_kept(model, chosen, in_any);
    if (left_out > 0) structure.dropped["assembly"] += left_out;
}

}  // namespace

void build_structure(const RawModel& model, const Chosen& chosen, const AssignedRadii& radii,
                     const std::string& assembly, Structure& structure) {
    Builder builder(model, chosen, radii, structure);
    if (!assembly.empty()) {
        append_assembly(model, chosen, find_assembly(model, assembly, structure.file), builder, structure);
        return;
    }
    builder.reserve(chosen.atoms.size());
    builder.append(
        RawOperator{}, false, [](std::uint32_t) { return true; }, [](const std::string& chain) { return chain; });
}

}  // namespace meniscus::reading
