"""How things that are rows of numbers become tables of other libraries."""

from abc import ABC, abstractmethod
from typing import TYPE_CHECKING, Any

from numpy.typing import NDArray

from tilewright.extras import need_package

if TYPE_CHECKING:
    import pandas
    import pyarrow


class Tabled(ABC):
    """Something that has columns by name, all of one length."""

    @abstractmethod
    def columns(self) -> dict[str, NDArray[Any]]:
        """Give the columns by name.

        Returns
        -------
        dict of str to array, shape (n,)
            The columns in order.
        """

    def to_pandas(self) -> "pandas.DataFrame":
        """Give the columns as a table of pandas.

        Returns
        -------
        pandas.DataFrame
            A row for each point, see `columns`.

        Raises
        ------
        MissingExtra
            The package pandas is not installed.
        """
        need_package("pandas", "to_pandas()")
        import pandas

        return pandas.DataFrame(self.columns())

    def to_arrow(self) -> "pyarrow.Table":
        """Give the columns as a table of Apache Arrow.

        Returns
        -------
        pyarrow.Table
            A row for each point, see `columns`.

        Raises
        ------
        MissingExtra
            The package pyarrow is not installed; the extra ``points`` brings it.
        """
        need_package("pyarrow", "to_arrow()")
        import numpy as np
        import pyarrow

        return pyarrow.table({name: np.ascontiguousarray(column) for name, column in self.columns().items()})
