# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: Apache-2.0
"""The model that ranks pockets, fitted to structures with ligands: what tools/fit-pockets and bench/pockets share.

docs/design/pockets.md says what the model is. Numbers of the fit are those of the shipped model.
"""
import csv
import gzip
import pathlib
import random
import subprocess
import sys
import zlib

try:
    import numpy as np
    from scipy.sparse import coo_matrix
    from scipy.spatial import cKDTree
    from sklearn.linear_model import LogisticRegression
except ImportError as error:
    sys.exit(f"{pathlib.Path(sys.argv[0]).name}: needs {error.name}, which is not installed; install python3-sklearn")

LIGAND = "LIG"  # residue name of the ligands' atoms
NEAR, FAR = 2.0, 4.0  # Å from a ligand's atom: positives are nearer than the first, negatives farther than the second
MOST_POSITIVES, MOST_NEGATIVES = 300, 900  # of a structure
SHARE_OF_POSITIVES = 1 / 12  # of a target's weight
WEIGHT_OF_TARGET = 1000.0
PENALTY = 20.0  # half of it times the square of each coefficient
FOLDS = 5

# As in src/pockets/sites.cpp.
LEAST = 0.05  # of the largest probability: of points that count
REACH = 8.0  # Å: of the kernel, of a centre's points, and of what a site takes away


class Structure:
    """A structure with its ligands, and what the program says of the points in its pockets."""

    def __init__(self, path, arrays, target, family):
        self.name, self.path, self.target, self.family = name_of(path), path, target, family
        atoms = [line for line in text_of(path).splitlines() if line.startswith(("ATOM", "HETATM")) and line[17:20] == LIGAND]
        self.ligand = np.array([[float(line[at:at + 8]) for at in (30, 38, 46)] for line in atoms]).reshape(-1, 3)
        self.ligand_of_atom = [line[21:27] for line in atoms]
        with np.load(arrays) as file:  # float32 keeps a few hundred structures within a GB
            self.points, self.features = file["point_xyz"], file["point_features"]
            self.feature_names = [str(name) for name in file["feature_names"]]
            self.centres = file["pocket_centre"]

    def distances(self, places):
        """Å from the nearest of the ligands' atoms."""
        return cKDTree(self.ligand).query(places)[0]


def name_of(path):
    return pathlib.Path(path).name.split(".")[0]


def text_of(path):
    data = pathlib.Path(path).read_bytes()
    return (gzip.decompress(data) if data[:2] == b"\x1f\x8b" else data).decode("latin-1")


def read_structures(folder, kept, program):
    """The structures of a folder. Without INDEX.tsv each is a target and a family of its own."""
    folder, kept = pathlib.Path(folder), pathlib.Path(kept)
    index = folder / "INDEX.tsv"
    rows = {}
    if index.exists():
        with index.open(encoding="utf-8") as file:
            rows = {row["name"]: row for row in csv.DictReader(file, delimiter="\t")}
    structures = []
    for path in sorted([*folder.glob("*.pdb"), *folder.glob("*.pdb.gz")]):
        name = name_of(path)
        arrays = kept / (name + ".npz")
        if not arrays.exists():
            subprocess.run([program, "pockets", path, "-o", arrays, "--quiet"], check=True)
        row = rows.get(name, {})
        structure = Structure(path, arrays, row.get("target_cluster", name), row.get("family", name))
        if len(structure.ligand):
            structures.append(structure)
    if not structures:
        sys.exit(f"{folder}: has no structures with atoms of a residue {LIGAND}, .pdb or .pdb.gz")
    return structures


def weights_of_structures(structures):
    """Each target counts once."""
    targets = [structure.target for structure in structures]
    return np.array([1 / targets.count(target) for target in targets])


def folds_of(structures, folds=FOLDS):
    """A fold for each structure: families, largest first, each into the fold with the fewest targets."""
    targets = {}
    for structure in structures:
        targets.setdefault(structure.family, set()).add(structure.target)
    sizes, fold_of = [0] * folds, {}
    for family in sorted(targets, key=lambda f: (-len(targets[f]), f)):
        fold_of[family] = sizes.index(min(sizes))
        sizes[fold_of[family]] += len(targets[family])
    return np.array([fold_of[structure.family] for structure in structures])


def examples_of(structure):
    """Indices of some points at ligands and of some that are not; the same whenever and with whatever others they are asked for."""
    distance = structure.distances(structure.points)
    chance = random.Random(zlib.crc32(structure.name.encode()))
    
    def some(indices, most):
        return np.array(sorted(chance.sample(list(indices), most)) if len(indices) > most else indices, dtype=int)

    return some(np.flatnonzero(distance < NEAR), MOST_POSITIVES), some(np.flatnonzero(distance > FAR), MOST_NEGATIVES)


def fit(structures, features_of=lambda structure: structure.features):
    """Intercept, and mean, scale and coefficient of each feature."""
    rows, labels, targets = [], [], []
    for structure in structures:
        features = features_of(structure)
        for label, indices in zip((1, 0), examples_of(structure)):
            rows.append(features[indices].astype(float))
            labels += [label] * len(indices)
            targets += [structure.target] * len(indices)
    rows, labels = np.vstack(rows), np.array(labels)
    _, targets = np.unique(targets, return_inverse=True)
    weights = np.empty(len(labels))
    for label, share in ((1, SHARE_OF_POSITIVES), (0, 1 - SHARE_OF_POSITIVES)):
        there = labels == label
        counts = np.bincount(targets[there], minlength=targets.max() + 1)
        weights[there] = WEIGHT_OF_TARGET * share / counts[targets[there]]
    mean, scale = standard(rows, weights)
    found = LogisticRegression(C=1 / PENALTY, solver="newton-cholesky", tol=1e-8, max_iter=200)
    found.fit((rows - mean) / scale, labels, sample_weight=weights)
    return found.intercept_[0], mean, scale, found.coef_[0]


def standard(rows, weights):
    mean = np.average(rows, axis=0, weights=weights)
    return mean, np.sqrt(np.average((rows - mean)**2, axis=0, weights=weights))


def probabilities(model, features):
    intercept, mean, scale, coefficients = model
    return 1 / (1 + np.exp(-(intercept + (features - mean) / scale @ coefficients)))


def sites(points, probability, count=3):
    """Centres of the best sites, best first."""
    if len(points) == 0:
        return np.empty((0, 3))
    kept = probability >= LEAST * probability.max()
    points, weights = points[kept], probability[kept]**2
    tree = cKDTree(points)
    pairs = tree.query_pairs(REACH, output_type="ndarray")
    values = 1 - ((points[pairs[:, 0]] - points[pairs[:, 1]])**2).sum(axis=1) / REACH**2
    half = coo_matrix((values, pairs.T), shape=(len(points),) * 2).tocsr()
    centres, open_points = [], np.ones(len(points), dtype=bool)
    while len(centres) < count and (weights > 0).any():
        density = weights + half @ weights + half.T @ weights
        densest = np.argmax(np.where(open_points, density, -1))
        own = tree.query_ball_point(points[densest], REACH)
        if weights[own].sum() == 0:
            break
        centres.append(np.average(points[own], axis=0, weights=weights[own]))
        taken = tree.query_ball_point(centres[-1], REACH)
        weights[taken], open_points[taken] = 0.0, False
        open_points[densest] = False
    return np.array(centres).reshape(-1, 3)
