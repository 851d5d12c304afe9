// SPDX-License-Identifier: Apache-2.0
#include "tests/support/cases/growth/BackwardScenes.h"

#include <functional>

namespace test {

namespace {

Codes where(const glm::ivec3& size, const std::function<bool(const glm::ivec3&)>& isTissue)
{
    Codes codes = constantVolume(size, 0);
    for (int z = 0; z < size.z; ++z) {
        for (int y = 0; y < size.y; ++y) {
            for (int x = 0; x < size.x; ++x) {
                if (isTissue({x, y, z}))
                    codes.at({x, y, z}) = tissueCode;
            }
        }
    }
    return codes;
}

} // namespace

BackwardScene lineScene()
{
    return {.name = "line",
        .codes = constantVolume({16, 1, 1}, tissueCode),
        .seeds = {{0, 0, 0}},
        .sketch = {{12, 0, 0}}};
}

BackwardScene ringScene()
{
    return {.name = "ring",
        .codes = where({9, 9, 1},
            [](const glm::ivec3& v) { return v.x == 0 || v.x == 8 || v.y == 0 || v.y == 8; }),
        .seeds = {{4, 0, 0}},
        .sketch = {{8, 6, 0}}};
}

BackwardScene forkScene()
{
    return {.name = "fork",
        .codes = where({8, 15, 1}, [](const glm::ivec3& v) { return v.y == 7 || v.x == 7; }),
        .seeds = {{0, 7, 0}},
        .sketch = {{7, 11, 0}}};
}

BackwardScene twoSeedsScene()
{
    BackwardScene scene = lineScene();
    scene.name = "two seeds";
    scene.seeds = {{0, 0, 0}, {15, 0, 0}};
    scene.sketch = {{10, 0, 0}};
    return scene;
}

std::vector<BackwardScene> backwardScenes()
{
    std::vector<BackwardScene> scenes{lineScene(), ringScene(), forkScene(), twoSeedsScene()};
    // The same, three voxels thick, and over the borders of bricks.
    scenes.push_back({.name = "thick ring",
        .codes = where({30, 30, 4},
            [](const glm::ivec3& v) {
                return v.z < 3 && (v.x < 3 || v.x > 26 || v.y < 3 || v.y > 26);
            }),
        .seeds = {{14, 1, 1}},
        .sketch = {{27, 20, 1}, {28, 20, 1}}});
    scenes.push_back({.name = "thick fork",
        .codes = where(
            {22, 29, 3}, [](const glm::ivec3& v) { return v.x > 18 || (v.y > 12 && v.y < 16); }),
        .seeds = {{0, 14, 1}},
        .sketch = {{19, 20, 1}, {20, 21, 1}}});
    scenes.push_back({.name = "hall behind a hole",
        .codes = where({34, 15, 15},
            [](const glm::ivec3& v) {
                return v.x < 15 || v.x > 16 || (v.y > 5 && v.y < 9 && v.z > 5 && v.z < 9);
            }),
        .seeds = {{2, 3, 4}},
        .sketch = {{22, 3, 3}, {22, 4, 3}, {22, 5, 4}, {22, 6, 4}}});
    scenes.push_back({.name = "block",
        .codes = constantVolume({18, 17, 9}, tissueCode),
        .seeds = {{1, 1, 1}, {2, 14, 7}},
        .sketch = {{13, 8, 4}, {14, 9, 5}}});
    scenes.push_back({.name = "block of two labels",
        .codes = constantVolume({20, 12, 7}, tissueCode),
        .seeds = {{1, 1, 1}},
        .others = {{18, 10, 5}},
        .sketch = {{7, 5, 3}, {12, 6, 3}}}); // of both
    return scenes;
}

} // namespace test
