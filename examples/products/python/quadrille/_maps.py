"""Sparse maps between the points of an input and those of a result."""

from __future__ import annotations

import dataclasses
from typing import Tuple

import numpy as np
from numpy.typing import ArrayLike

from ._forms import Array


@dataclasses.dataclass(frozen=True, eq=False, repr=False)
class SparseMap:
    """A sparse matrix by rows (CSR), which takes values at points of one mesh to points of another one.

        values = result.old_to_new @ values_at_result             # by numpy
        matrix = scipy.sparse.csr_matrix(result.old_to_new.csr, result.old_to_new.shape)
        tensor = torch.sparse_csr_tensor(*map(torch.from_numpy, (m.indptr, m.indices, m.weights)), m.shape)

    Row i has the entries from indptr[i] to indptr[i + 1]: up to three points with weights above 0 and of the sum 1
    (up to rounding), a place on a face; or none.

    indptr   integers of the shape (rows + 1,)
    indices  integers: for each entry, its column
    weights  numbers: for each entry, its weight
    shape    the numbers of rows and columns
    """

    indptr: Array
    indices: Array
    weights: Array
    shape: Tuple[int, int]

    @property
    def csr(self) -> Tuple[Array, Array, Array]:
        """(weights, indices, indptr), in the order of scipy.sparse.csr_matrix and csr_array."""
        return self.weights, self.indices, self.indptr

    def __matmul__(self, values: ArrayLike) -> Array:
        """Returns the product with a value for each column, of the shape (columns,) or (columns, components): a value for
        each row, 0 for empty ones."""
        given: Array = np.asarray(values)
        if given.ndim not in (1, 2) or len(given) != self.shape[1]:
            raise ValueError(f"the values have the shape {given.shape}, not ({self.shape[1]},) or ({self.shape[1]}, n)")
        weights = self.weights if given.ndim == 1 else self.weights[:, None]
        products = given[self.indices] * weights
        result: Array = np.zeros((self.shape[0], *given.shape[1:]), products.dtype)
        has_entries = np.diff(self.indptr) > 0
        if has_entries.any():
            result[has_entries] = np.add.reduceat(products, self.indptr[:-1][has_entries], axis=0)
        return result

    def __repr__(self) -> str:
        return f"<quadrille.SparseMap: {self.shape[0]} x {self.shape[1]}, {len(self.indices)} entries>"
