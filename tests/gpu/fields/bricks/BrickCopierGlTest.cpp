// SPDX-License-Identifier: Apache-2.0
#include "gpu/fields/bricks/BrickCopier.h"
#include "gpu/gl/Program.h"
#include "tests/support/fixtures/frames/FrameTest.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/TestVolumes.h"

#include <QTest>

#include <algorithm>
#include <array>
#include <numeric>
#include <span>
#include <utility>
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
        CopyPrograms programs(m_fixture->shaders);
        const BrickCopier copier(programs, core::BrickGrid{size}, WorkBy::Kernels);
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

    void processorAndKernelsAgree_data()
    {
        QTest::addColumn<core::Field>("field");
        for (const auto& [name, field] :
            {std::pair("coverage", core::Field::Coverage), std::pair("labels", core::Field::Labels),
                std::pair("overwritten labels", core::Field::Overwritten),
                std::pair("seed words", core::Field::SeedWords)})
            QTest::addRow("%s", name) << field;
    }

    /// In a volume whose last bricks reach beyond it, with bricks that hold nothing.
    void processorAndKernelsAgree()
    {
        QFETCH(core::Field, field);
        const glm::ivec3 size(35, 16, 17);
        m_fixture->open(test::centredGeometry(size), [](const glm::dvec3&) { return 1000.0; });
        const core::BrickGrid grid{size};
        reference::DenseFields state(size);
        std::vector<std::uint32_t> bricks;
        std::vector<Image> expected;
        test::Random random(std::uint32_t(field) + 5);
        for (std::uint32_t brick = 0; brick < std::uint32_t(grid.brickCount()); ++brick) {
            Image image(packedBrickBytes(field));
            for (std::uint8_t& byte : image)
                byte = std::uint8_t(test::randomInt(random, 0, 255));
            if (brick % 3 != 1)
                state.writeBrick({field, 0, brick}, image);
            bricks.push_back(brick);
            expected.push_back(state.readBrick({field, 0, brick}));
        }
        m_fixture->put(state);
        CopyPrograms programs(m_fixture->shaders);
        const BrickCopier kernels(programs, grid, WorkBy::Kernels);
        const BrickCopier processor(programs, grid, WorkBy::Processor);
        const auto textures = [&] { return m_fixture->edits.fields->textures(field, 0); };
        const std::array copiers{&kernels, &processor};
        for (const BrickCopier* const reads : copiers)
            QCOMPARE(reads->images(textures(), bricks), expected);
        if (BrickField* const paged = m_fixture->edits.fields->paged(field, 0))
            paged->ensure(bricks);

        std::vector<Image> others(expected.rbegin(), expected.rend());
        for (std::size_t i = 0; i < others.size(); ++i) {
            // What lies outside of the volume stays empty.
            state.writeBrick({field, 0, bricks[i]},
                others[i].empty() ? Image(packedBrickBytes(field), core::emptyByte(field))
                                  : others[i]);
            others[i] = state.readBrick({field, 0, bricks[i]});
        }
        const Image none;
        for (const BrickCopier* const writes : copiers) {
            const BrickCopier* const reads = writes == &kernels ? &processor : &kernels;
            std::vector<const Image*> images;
            for (const Image& image : others)
                images.push_back(&image);
            writes->write(textures(), bricks, images);
            QCOMPARE(reads->images(textures(), bricks), others);
            // By way of a buffer; one brick is left out.
            const Buffer packed = writes->packed(textures(), bricks);
            writes->write(textures(), bricks, std::vector<const Image*>(bricks.size(), &none));
            QCOMPARE(reads->images(textures(), bricks), std::vector<Image>(bricks.size()));
            std::vector<std::uint32_t> asked = bricks;
            asked[0] = BrickCopier::skipped;
            writes->write(textures(), asked, packed);
            std::vector<Image> wanted = others;
            wanted[0] = {};
            QCOMPARE(reads->images(textures(), bricks), wanted);
        }
    }
};

BURIN_TEST(BrickCopierGlTest)

} // namespace brickCopierGlTest

#include "BrickCopierGlTest.moc"
