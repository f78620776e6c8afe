// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Prints what Khronos' glTF validator finds in GLB files, as one line of JSON per file.
// usage: NODE_PATH=FOLDER/node_modules node validate_glb.js FILE.glb ...
'use strict';
const fs = require('fs');
const validator = require('gltf-validator');

(async () => {
  for (const file of process.argv.slice(2)) {
    const report = await validator.validateBytes(new Uint8Array(fs.readFileSync(file)));
    console.log(JSON.stringify(report));
  }
})();
