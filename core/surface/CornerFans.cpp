// SPDX-License-Identifier: Apache-2.0
#include "core/surface/CornerFans.h"

#include <algorithm>

namespace core {

namespace {

constexpr std::uint8_t noFan = 255;

bool inside(int configuration, int voxel)
{
    return ((configuration >> voxel) & 1) != 0;
}

CornerFans fansOf(int configuration)
{
    std::array<int, 12> root{};
    std::array<bool, 12> exists{};
    for (int face = 0; face < 12; ++face) {
        const int axis = face / 4;
        const int next = (axis + 1) % 3;
        const int second = (axis + 2) % 3;
        const int before = ((face & 1) << next) | (((face >> 1) & 1) << second);
        exists[std::size_t(face)] =
            inside(configuration, before) != inside(configuration, before | (1 << axis));
        root[std::size_t(face)] = face;
    }
    const auto unite = [&](int a, int b) {
        std::replace(
            root.begin(), root.end(), int(root[std::size_t(b)]), int(root[std::size_t(a)]));
    };
    CornerFans fans;
    for (int axis = 0; axis < 3; ++axis) {
        const int b = (axis + 1) % 3;
        const int c = (axis + 2) % 3;
        for (int beyond = 0; beyond < 2; ++beyond) {
            // The four faces around the edge, and the voxel between each two of them.
            const auto acrossB = [&](int bitC) { return cornerFace(b, bitC, beyond); };
            const auto acrossC = [&](int bitB) { return cornerFace(c, beyond, bitB); };
            int around = 0;
            int first = -1;
            int last = -1;
            for (const int face : {acrossB(0), acrossB(1), acrossC(0), acrossC(1)}) {
                if (!exists[std::size_t(face)])
                    continue;
                ++around;
                first = first < 0 ? face : first;
                last = face;
            }
            if (around == 2)
                unite(first, last);
            if (around != 4)
                continue;
            fans.crossed |= std::uint8_t(1U << unsigned(2 * axis + beyond));
            for (const int bitB : {0, 1}) {
                for (const int bitC : {0, 1}) {
                    if (inside(configuration, (beyond << axis) | (bitB << b) | (bitC << c)))
                        unite(acrossB(bitC), acrossC(bitB));
                }
            }
        }
    }
    fans.fanOf.fill(noFan);
    for (int face = 0; face < 12; ++face) {
        if (!exists[std::size_t(face)] || fans.fanOf[std::size_t(face)] != noFan)
            continue;
        for (int other = face; other < 12; ++other) {
            if (exists[std::size_t(other)] && root[std::size_t(other)] == root[std::size_t(face)])
                fans.fanOf[std::size_t(other)] = fans.count;
        }
        ++fans.count;
    }
    return fans;
}

std::array<CornerFans, 256> allFans()
{
    std::array<CornerFans, 256> all;
    for (int configuration = 0; configuration < 256; ++configuration)
        all[std::size_t(configuration)] = fansOf(configuration);
    return all;
}

} // namespace

const CornerFans& cornerFans(std::uint8_t configuration)
{
    static const std::array<CornerFans, 256> all = allFans();
    return all[configuration];
}

} // namespace core
