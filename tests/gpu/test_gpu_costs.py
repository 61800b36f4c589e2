"""What a sample costs on a GPU, counted in compiled shaders."""

import pytest

from costs import cost_table, count_cost, missing_tools
from tilewright.errors import GpuError

counted = pytest.mark.skipif(bool(missing_tools()), reason=f"{', '.join(missing_tools())} not installed")


@counted
@pytest.mark.parametrize("colors", [2, 3, 4, 8])
@pytest.mark.parametrize("hash", ["mixer", "permutation"])
def test_corner_tiles_cost_less_than_wei(hash, colors):
    plain, array, atlas, wei = (
        count_cost(method, hash=hash, colors=colors) for method in ("plain", "array", "atlas", "wei")
    )
    assert (plain.fetches, plain.textures, plain.table_reads) == (1, 1, 0)
    for corner in (array, atlas):
        assert corner.fetches == corner.textures == 1
        for ours, theirs, floor in zip(
            corner.instructions, wei.instructions, plain.instructions, strict=True
        ):
            assert floor < ours < theirs
        for ours, theirs in zip(corner.operations, wei.operations, strict=True):
            assert ours < theirs
    assert wei.fetches == 1
    assert wei.textures == 2
    assert 2 * atlas.texels == wei.texels
    assert atlas.texels < array.texels < 1.3 * atlas.texels < wei.texels
    if hash == "mixer":
        assert array.table_reads == array.dependent == 0
        # Only where a cell and its neighbor differ in sign two more rows are hashed.
        assert array.instructions[0] + 40 < array.instructions[1]
    else:
        assert (array.table_reads, array.dependent) == (6, 2)
        assert (wei.table_reads, wei.dependent) == (7, 2)


@counted
def test_what_is_counted():
    # A repeated picture: two derivatives, coordinate and gradients by a constant, one fetch, moves around it.
    assert count_cost("plain").instructions == (11, 11)


@counted
def test_tone_costs_three_fetches_more():
    classed, tone = count_cost("classed"), count_cost("tone")
    assert (classed.fetches, tone.fetches) == (1, 4)
    assert (classed.textures, tone.textures) == (1, 2)
    assert tone.instructions[1] < 500
    assert tone.texels - classed.texels == 64**2


def test_counting_without_tools(monkeypatch):
    import costs

    monkeypatch.setattr(costs, "which", lambda tool: None)
    with pytest.raises(
        GpuError, match=r"counting needs glslangValidator.*apt-get install glslang-tools spirv-tools$"
    ):
        costs._compile.__wrapped__("")


@counted
def test_a_shader_that_does_not_compile_shows_its_log():
    from costs import _compile

    with pytest.raises(GpuError, match=r"glslangValidator refused the shader; it says:\n(.|\n)*nonsense"):
        _compile("#version 450\nvoid main() { nonsense(1); }")


@counted
def test_the_table_has_every_method_with_both_hashes():
    table = cost_table(colors=3)
    named = [(cost.method, cost.hash) for cost in table]
    assert len(set(named)) == 9
    hashed = ("array", "atlas", "wei")
    assert [method for method, _ in named] == ["plain", *hashed, "classed", "tone", *hashed]
    assert table[1] == count_cost("array", hash="mixer", colors=3)
