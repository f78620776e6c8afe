// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "structure/input_file.h"

#include <sys/stat.h>

#include <fstream>
#include <thread>

#include "fragments.h"

namespace meniscus::reading {
namespace {

using meniscus::testing::expect_contains;
using meniscus::testing::gzipped;
using meniscus::testing::ScratchFolder;

constexpr const char* kAtom = "ATOM      1  N   ALA A   1       0.000   0.000   0.000\n";

std::string error_of_bytes(const std::string& bytes, const std::string& path) {
    try {
        load_bytes(bytes, path);
    } catch (const InputError& error) {
        return error.what();
    }
    return "";
}

TEST(InputFile, SuffixTellsTheFormatInAnyCase) {
    EXPECT_EQ(load_bytes(kAtom, "a.pdb").format, Format::Pdb);
    EXPECT_EQ(load_bytes(kAtom, "a.ENT").format, Format::Pdb);
    EXPECT_EQ(load_bytes("data_a\n", "a.cif").format, Format::Cif);
    EXPECT_EQ(load_bytes("data_a\n", "a.mmcif").format, Format::Cif);
    EXPECT_EQ(load_bytes(kAtom, "a.pdbqt").format, Format::Pdbqt);
    for (const char* name : {"a.pdb1", "a.PDB9", "a.pdb12"}) EXPECT_EQ(load_bytes(kAtom, name).name, "a") << name;
    EXPECT_EQ(stem_of("d/1abc.pdb2.gz"), "1abc");
    for (const char* name : {"a.pdb123", "a.pdbx", "a.ent1", "a.1"})
        expect_contains(error_of_bytes(kAtom, name), "unknown suffix");
    EXPECT_EQ(load_bytes(kAtom, "a.pqr").format, Format::Pqr);
    EXPECT_EQ(load_bytes("0 0 0 1\n", "a.xyzr").format, Format::Xyzr);
    EXPECT_EQ(load_bytes("0 0 0 1\n", "a.xyzrn").format, Format::Xyzrn);
}

TEST(InputFile, UnknownSuffixesAreErrorsThatNameTheKnown) {
    expect_contains(error_of_bytes(kAtom, "a.txt"), ".pdb .ent .cif .mmcif .bcif .gro .pdbqt .pqr .xyzr .xyzrn");
    expect_contains(error_of_bytes("", "/dev/null"), "unknown suffix");
}

TEST(InputFile, StandardInputIsToldByContent) {
    EXPECT_EQ(load_bytes(kAtom, "-").format, Format::Pdb);
    EXPECT_EQ(load_bytes("HEADER\n", "-").format, Format::Pdb);
    EXPECT_EQ(load_bytes("# x\n\ndata_a\n", "-").format, Format::Cif);
    EXPECT_EQ(load_bytes("# spheres\n 0 0 0 1\n", "-").format, Format::Xyzr);
    EXPECT_EQ(load_bytes(gzipped("0 0 0 1\n"), "-").format, Format::Xyzr);
    expect_contains(error_of_bytes("hello\n", "-"), "neither PDB nor mmCIF nor GROMACS nor xyzr");
    expect_contains(error_of_bytes("", "-"), "nothing came on standard input");
}

TEST(InputFile, StemsLoseFolderAndSuffixes) {
    EXPECT_EQ(stem_of("dir.x/1ubq.pdb.gz"), "1ubq");
    EXPECT_EQ(stem_of("1aon.from-mmtf.cif.gz"), "1aon.from-mmtf");
    EXPECT_EQ(stem_of("A.PDB"), "A");
    EXPECT_EQ(stem_of("-"), "stdin");
}

TEST(InputFile, FingerprintIsOfTheBytesAsFound) {
    const std::string bytes = gzipped(kAtom);
    EXPECT_NE(load_bytes(bytes, "a.pdb.gz").sha256, load_bytes(kAtom, "a.pdb").sha256);
    EXPECT_EQ(load_bytes(bytes, "a.pdb.gz").text, kAtom);
}

TEST(InputFile, GzipUnderAPlainNameIsReadWithANote) {
    const InputFile file = load_bytes(gzipped(kAtom), "a.pdb");
    EXPECT_EQ(file.text, kAtom);
    EXPECT_EQ(file.notes.size(), 1U);
}

TEST(InputFile, PlainTextUnderAGzipNameIsAnError) {
    expect_contains(error_of_bytes(kAtom, "a.pdb.gz"), "contains no gzip data");
}

TEST(InputFile, WhatIsNoStructureIsNamed) {
    expect_contains(error_of_bytes("<!DOCTYPE html>\n<html>", "a.pdb"), "HTML page");
    expect_contains(error_of_bytes("\n<HTML><head>", "a.cif"), "HTML page");
    expect_contains(error_of_bytes("<?xml version='1.0'?>", "a.pdb"), "XML");
    expect_contains(error_of_bytes("{\"data_1\": 1}", "a.pdb"), "JSON");
    expect_contains(error_of_bytes("data_1\nloop_\n", "a.pdb"), "rename it to .cif");
    expect_contains(error_of_bytes(kAtom, "a.cif"), "rename it to .pdb");
    expect_contains(error_of_bytes(std::string("HEADER\nAT\0M", 11), "a.pdb"), "a.pdb:2:3: a zero byte");
}

TEST(InputFile, ZeroBytesBehindTheLastRecordArePadding) {
    const std::string zeros(100, '\0');
    for (const std::string& end : {zeros, "  " + zeros, zeros + "\n", zeros + "\r\n" + zeros}) {
        const InputFile file = load_bytes(kAtom + end, "a.pdb");
        EXPECT_TRUE(file.text.starts_with(kAtom));
        EXPECT_EQ(file.text.find('\0'), std::string::npos);
        ASSERT_EQ(file.warnings.size(), 1U);
        expect_contains(file.warnings[0], "line 2: zero bytes behind the last record");
    }
    EXPECT_EQ(load_bytes("data_a\n" + zeros, "a.cif").warnings.size(), 1U);
    expect_contains(error_of_bytes(kAtom + zeros + kAtom, "a.pdb"), "a.pdb:2:1: a zero byte");
    expect_contains(error_of_bytes(zeros, "a.pdb"), "a.pdb:1:1: a zero byte");
}

TEST(InputFile, MarksAndLineEndsAreToldWhereSomethingIsAssumed) {
    EXPECT_TRUE(load_bytes("HEADER\r\nEND\r\n", "a.pdb").notes.empty());
    EXPECT_EQ(load_bytes("HEADER\nTITLE\rEND\n", "a.pdb").notes.at(0),
              "line 2: a line ends with a carriage return alone, taken as its end");
    EXPECT_EQ(load_bytes("\xEF\xBB\xBFHEADER\n", "a.pdb").notes.at(0), "line 1: a byte-order mark, left out");
    expect_contains(error_of_bytes(std::string("\xFF\xFE"
                                               "A\0T\0O\0M\0",
                                               10),
                                   "a.pdb"),
                    "a.pdb:1:1: text in UTF-16");
}

TEST(InputFile, StandardInputMayBeginWithALowerCaseRecord) {
    EXPECT_EQ(load_bytes(" atom      1  N   ALA A   1       0.000   0.000   0.000\n", "-").format, Format::Pdb);
}

TEST(InputFile, CommentsOfMmcifWithCoordinatesAreAWarning) {
    const std::string row = "ATOM 1 N N ALA A 1 27.340 24.430 2.614 1.00 9.67\n";
    EXPECT_TRUE(load_bytes("data_a\n# ATOM is a record\n#\n" + row, "a.cif").warnings.empty());
    const InputFile file = load_bytes("data_a\n#" + row + row + "# " + row, "a.cif");
    ASSERT_EQ(file.warnings.size(), 1U);
    expect_contains(file.warnings[0], "line 2: '#ATOM 1 N");
    expect_contains(file.warnings[0], "is a comment, but has coordinates as an atom has; left out (2 times)");
}

TEST(InputFile, FoldersAndMissingFilesAreErrors) {
    EXPECT_THROW(load_input("/"), InputError);
    EXPECT_THROW(load_input("/no/such.pdb"), InputError);
}

TEST(InputFile, APipeIsReadToItsEnd) {
    const ScratchFolder folder;
    const std::string path = folder / "pipe.pdb";
    ASSERT_EQ(mkfifo(path.c_str(), 0600), 0);
    std::thread writer([&] { std::ofstream(path) << kAtom << kAtom; });
    EXPECT_EQ(load_input(path).text, std::string(kAtom) + kAtom);
    writer.join();
}

}  // namespace
}  // namespace meniscus::reading
