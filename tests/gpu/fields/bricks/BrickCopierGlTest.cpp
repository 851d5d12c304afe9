// SPDX-License-Identifier: Apache-2.0
#include "gpu/fields/bricks/BrickCopier.h"
#include "gpu/gl/Program.h"
#include "tests/support/fixtures/frames/FrameTest.h"
#include "tests/support/program/TestProgram.h"

#include <QTest>

#include <algorithm>
#include <numeric>
#include <span>
#include <vector>

namespace brickCopierGlTest {

using namespace gpu;

using Image = std::vector<std::uint8_t>;

/// Bricks go into a buffer and come back as they were.
class BrickCopierGlTest : public test::FrameTest {
    Q_OBJECT

private Q_SLOTS:
    /// A driver starts 65,535 work groups at once, and has storage blocks of 128 MiB: a list that
    /// is longer (of a large volume, but the same few bricks will do) is copied to its end.
    void listsOfAnyLength()
    {
        const glm::ivec3 size(32);
        m_fixture->open(test::centredGeometry(size), [](const glm::dvec3&) { return 1000.0; });
        reference::DenseFields state(size);
        std::vector<std::uint8_t>& values = state.labels(0).values;
        for (std::size_t i = 0; i < values.size(); ++i)
            values[i] = std::uint8_t(1 + i % 251);
        m_fixture->put(state);
        const BrickCopier& copier = m_fixture->edits.fields->copier();
        const FieldTextures labels = m_fixture->edits.fields->textures(core::Field::Labels, 0);
        const std::size_t grid = 8;
        std::vector<Image> expected;
        for (std::uint32_t brick = 0; brick < grid; ++brick)
            expected.push_back(state.readBrick({core::Field::Labels, 0, brick}));

        const std::size_t count = 70000;
        QVERIFY(count > mostWorkGroups);
        std::vector<std::uint32_t> bricks(count);
        for (std::size_t i = 0; i < count; ++i)
            bricks[i] = std::uint32_t(i % grid);
        const Buffer packed = copier.packed(labels, bricks);
        const std::size_t bytes = packedBrickBytes(core::Field::Labels);
        QCOMPARE(packed.bytes(), count * bytes);
        for (const std::size_t slot :
            {std::size_t(0), std::size_t(8191), std::size_t(8195), std::size_t(32769),
                mostWorkGroups - 1, mostWorkGroups, mostWorkGroups + 1, count - 1}) {
            Image image(bytes);
            packed.read(std::span<std::uint8_t>(image), slot * bytes);
            QVERIFY2(image == expected[slot % grid], qPrintable(QString::number(slot)));
        }

        // Only the end of the list is written.
        std::vector<std::uint32_t> whole(grid);
        std::iota(whole.begin(), whole.end(), 0u);
        const Image none;
        copier.write(labels, whole, std::vector<const Image*>(grid, &none));
        QCOMPARE(copier.images(labels, whole), std::vector<Image>(grid));
        std::fill(bricks.begin(), bricks.end() - std::ptrdiff_t(grid), BrickCopier::skipped);
        copier.write(labels, bricks, packed);
        QCOMPARE(copier.images(labels, whole), expected);
    }
};

BURIN_TEST(BrickCopierGlTest)

} // namespace brickCopierGlTest

#include "BrickCopierGlTest.moc"
