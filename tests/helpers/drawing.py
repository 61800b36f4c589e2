"""Whether there is a GPU to draw with, and why not."""

import pytest

from tilewright.errors import GpuError
from tilewright.gpu.device import open_gpu


def why_no_gpu():
    """The reason, None where there is one."""
    try:
        open_gpu()
    except GpuError as error:
        return str(error)
    return None


drawn = pytest.mark.skipif(why_no_gpu() is not None, reason=f"{why_no_gpu()}")
