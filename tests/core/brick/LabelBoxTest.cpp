// SPDX-License-Identifier: Apache-2.0
#include "core/brick/LabelBox.h"

#include "core/brick/RunRows.h"
#include "tests/support/program/TestProgram.h"

#include <QTest>

#include <array>
#include <random>
#include <utility>
#include <vector>

namespace labelBoxTest {

namespace {

constexpr std::array<glm::ivec3, 5> sizes{
    glm::ivec3(7, 6, 5), {40, 3, 2}, {1, 9, 4}, {9, 1, 4}, {9, 4, 1}};

template <class Visit> void forEachVoxel(const glm::ivec3& size, const Visit& visit)
{
    std::size_t voxel = 0;
    for (int z = 0; z < size.z; ++z) {
        for (int y = 0; y < size.y; ++y) {
            for (int x = 0; x < size.x; ++x, ++voxel)
                visit(glm::ivec3(x, y, z), voxel);
        }
    }
}

} // namespace

/// Boxes around voxels, and rows of runs, held to a look at every voxel.
class LabelBoxTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void boxOfALabel()
    {
        std::mt19937 random(2);
        int empty = 0;
        int inside = 0;
        for (int round = 0; round < 400; ++round) {
            const glm::ivec3 size = sizes.at(std::size_t(round) % sizes.size());
            std::vector<std::uint8_t> labels(std::size_t(size.x * size.y * size.z));
            const unsigned per = 1U << (random() % 8); // from a single voxel or none to all of them
            core::VoxelBox expected;
            forEachVoxel(size, [&](const glm::ivec3& at, std::size_t voxel) {
                labels[voxel] = std::uint8_t(random() % per == 0 ? 1 : 2 * (random() % 2));
                if (labels[voxel] == 1)
                    expected = expected.united({at, at + 1});
            });
            const core::VoxelBox box = core::boxOfLabel(labels, size, 1);
            QCOMPARE(box.empty(), expected.empty());
            if (expected.empty()) {
                ++empty;
                continue;
            }
            QCOMPARE(box.minimum, expected.minimum);
            QCOMPARE(box.maximum, expected.maximum);
            inside += box.minimum != glm::ivec3(0) && box.maximum != size ? 1 : 0;
        }
        QVERIFY2(empty > 5 && inside > 5,
            qPrintable(QStringLiteral("%1 empty, %2 away from the "
                                      "borders")
                           .arg(empty)
                           .arg(inside)));
    }

    void partsOfRows()
    {
        std::mt19937 random(3);
        for (int round = 0; round < 200; ++round) {
            const glm::ivec3 size = sizes.at(std::size_t(round) % sizes.size());
            core::VoxelRuns runs;
            std::vector<std::pair<glm::ivec3, std::uint64_t>> expected;
            const unsigned per = 1 + unsigned(random() % 6);
            forEachVoxel(size, [&](const glm::ivec3& at, std::size_t voxel) {
                if (random() % per != 0)
                    return;
                runs.append(voxel, 1);
                expected.emplace_back(at, voxel);
            });
            std::vector<std::pair<glm::ivec3, std::uint64_t>> found;
            core::forEachRowPart(
                runs, size, [&](const glm::ivec3& at, int count, std::uint64_t first) {
                    QVERIFY(count > 0 && at.x + count <= size.x);
                    for (int i = 0; i < count; ++i)
                        found.emplace_back(at + glm::ivec3(i, 0, 0), first + std::uint64_t(i));
                });
            QVERIFY(found == expected);
        }
    }
};

BURIN_TEST(LabelBoxTest)

} // namespace labelBoxTest

#include "LabelBoxTest.moc"
