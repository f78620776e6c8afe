// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Exact areas and volumes of a folder of structures, a process for every 100 of them (docs/reference/batch.md):
//   nextflow run examples/workflows/measure.nf --structures 'structures/*.cif' --out measured
// measured/results.jsonl has one line for each structure, failures included. Not tried: Nextflow does not run where
// Meniscus is tested.
nextflow.enable.dsl = 2

params.structures = 'structures/*.{pdb,cif,bcif,gz}'
params.out = 'measured'
params.options = ''  // of meniscus measure, such as '--radii bondi'

process MEASURE {
    input:
    path structures

    output:
    path 'part.jsonl'

    // Exit code 6: some structures failed. They have their lines in the results.
    script:
    """
    meniscus batch measure ${structures} --out part --jobs ${task.cpus} ${params.options} || [ \$? -eq 6 ]
    mv part/results.jsonl part.jsonl
    """
}

workflow {
    Channel.fromPath(params.structures)
        | buffer(size: 100, remainder: true)
        | MEASURE
        | collectFile(name: 'results.jsonl', storeDir: params.out)
}
