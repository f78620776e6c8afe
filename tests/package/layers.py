# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: Apache-2.0
"""All that is written in a file, also where it is packed: members of archives, compressed streams, base64, of each other."""
import base64
import io
import re
import zipfile
import zlib

BASE64 = re.compile(rb"[A-Za-z0-9+/]{64,}={0,2}")
# The second byte of a zlib stream is a check on both; these are the ones in use.
ZLIB = re.compile(rb"\x78[\x01\x5e\x9c\xda]|\x1f\x8b\x08")
DEEPEST = 4


def layers(content, depth=0):
    """The bytes, and those of every layer below."""
    yield content
    if depth < DEEPEST:
        for inner in unpacked(content):
            yield from layers(inner, depth + 1)


def unpacked(content):
    if content[:2] == b"PK":
        with zipfile.ZipFile(io.BytesIO(content)) as archive:
            yield from (archive.read(name) for name in archive.namelist())
    for found in ZLIB.finditer(content):
        yield from inflated(content[found.start():], 47)  # zlib's word for: zlib or gzip, tell by the head
    yield from inflated(content, -15)
    for found in BASE64.finditer(content):
        digits = found.group().rstrip(b"=")
        yield base64.b64decode(digits[:len(digits) - (len(digits) % 4 == 1)] + b"===")


def inflated(content, kind):
    """What comes out of a stream as far as it is one; a few bytes are chance."""
    inflater, out = zlib.decompressobj(kind), b""
    try:
        for start in range(0, len(content), 4096):
            out += inflater.decompress(content[start:start + 4096])
            if inflater.eof:
                break
    except zlib.error:
        pass
    if len(out) > 32:
        yield out


def png_streams(content):
    """A PNG's chunks without their frames, so that a stream spread over several of them is one again."""
    at, data = 8, b""
    while content[:4] == b"\x89PNG" and at + 8 <= len(content):
        size = int.from_bytes(content[at:at + 4], "big")
        data += content[at + 8:at + 8 + size]
        at += 12 + size
    return data


def mentions(content, words):
    """Those of the words that are written anywhere in it, whatever the case."""
    texts = [layer.lower() for layer in (*layers(content), *layers(png_streams(content)))]
    return {word for word in words if any(word.lower().encode() in text for text in texts)}
