//! Surfaces: polygon meshes with identified edges, their verdicts with witnesses, halfedge permutations.
