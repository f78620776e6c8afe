// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// What the two files that include gemmi share, without including it.
#pragma once

#include <cstddef>
#include <exception>
#include <new>
#include <string>
#include <vector>

#include "meniscus/errors.h"
#include "reading/text.h"
#include "structure/raw_model.h"

namespace gemmi::cif {
struct Block;
}

namespace meniscus::reading {

/// What is taken of gemmi's messages, which may repeat all that is wrong; bytes.
inline constexpr std::size_t kOfGemmi = 300;

/// Whatever gemmi does not like about a file is an error of the input; memory that there is not is none.
template <class Read>
auto with_input_errors(const std::string& file, Read read) {
    try {
        return read();
    } catch (const InputError&) {
        throw;
    } catch (const LimitError&) {
        throw;
    } catch (const std::bad_alloc&) {
        throw;
    } catch (const std::exception& error) {
        throw InputError(file + ": " + printable(error.what(), kOfGemmi) + "; correct the file or fetch it again");
    }
}

/// As gemmi interprets a block of mmCIF, which is to hold nothing but categories of assemblies.
std::vector<RawAssembly> assemblies_of(const gemmi::cif::Block& block);

}  // namespace meniscus::reading
