// SPDX-License-Identifier: Apache-2.0
#include "gpu/render/parts/TileParts.h"

namespace gpu {

Tile commonPart(const Tile& a, const Tile& b)
{
    const glm::ivec2 low = glm::max(a.minimum, b.minimum);
    const glm::ivec2 high = glm::min(a.minimum + a.size, b.minimum + b.size);
    return glm::all(glm::lessThan(low, high)) ? Tile{low, high - low} : Tile{};
}

Tile unionOf(const Tile& a, const Tile& b)
{
    const glm::ivec2 low = glm::min(a.minimum, b.minimum);
    return {low, glm::max(a.minimum + a.size, b.minimum + b.size) - low};
}

std::vector<Tile> partsAround(const Tile& tile, const Tile& hole)
{
    if (hole.size.x == 0)
        return {tile};
    const glm::ivec2 end = tile.minimum + tile.size;
    const glm::ivec2 holeEnd = hole.minimum + hole.size;
    std::vector<Tile> parts;
    for (const Tile& part : {Tile{tile.minimum, {tile.size.x, hole.minimum.y - tile.minimum.y}},
             Tile{{tile.minimum.x, hole.minimum.y}, {hole.minimum.x - tile.minimum.x, hole.size.y}},
             Tile{{holeEnd.x, hole.minimum.y}, {end.x - holeEnd.x, hole.size.y}},
             Tile{{tile.minimum.x, holeEnd.y}, {tile.size.x, end.y - holeEnd.y}}}) {
        if (part.size.x > 0 && part.size.y > 0)
            parts.push_back(part);
    }
    return parts;
}

} // namespace gpu
