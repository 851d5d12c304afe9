// SPDX-License-Identifier: Apache-2.0
#include "gpu/fields/textures/ShownLabels.h"

#include "core/document/Document.h"
#include "gpu/fields/BrickImages.h"
#include "tests/reference/fields/Radiation.h"
#include "tests/support/fixtures/frames/FrameTest.h"
#include "tests/support/program/TestProgram.h"

#include <QTest>

#include <algorithm>
#include <random>
#include <span>
#include <vector>

namespace shownLabelsGlTest {

using namespace gpu;
using Bytes = reference::DenseArray<std::uint8_t>;

/// What the 3D view sees of several label planes, and the segmentation map of all of them, equal
/// what their rules say, voxel for voxel.
class ShownLabelsGlTest : public test::FrameTest {
    Q_OBJECT

    /// A few boxes of random labels from 1 to 5.
    static void scatter(Bytes& labels, std::mt19937& random)
    {
        const auto between = [&](int low, int high) {
            return low + int(random() % std::uint32_t(high - low + 1));
        };
        for (int i = between(2, 6); i > 0; --i) {
            glm::ivec3 low;
            glm::ivec3 high;
            for (int axis = 0; axis < 3; ++axis) {
                low[axis] = between(0, labels.size[axis] - 1);
                high[axis] = std::min(low[axis] + between(1, 20), labels.size[axis]);
            }
            const auto label = std::uint8_t(between(1, 5));
            for (int z = low.z; z < high.z; ++z)
                for (int y = low.y; y < high.y; ++y)
                    for (int x = low.x; x < high.x; ++x)
                        labels.at({x, y, z}) = label;
        }
    }

    static std::bitset<256> someLabels(std::mt19937& random)
    {
        std::bitset<256> labels;
        for (std::size_t label = 1; label <= 5; ++label)
            labels[label] = random() % 2 != 0;
        return labels;
    }

    void update() const
    {
        while (m_fixture->edits.fields->segmentationStale())
            m_fixture->edits.fields->updateSegmentation(3);
    }

    [[nodiscard]] Bytes read(const Texture3D& texture) const
    {
        Bytes bytes{m_fixture->volume.size(), {}};
        bytes.values.resize(texture.bytes());
        texture.read(glm::ivec3(0), bytes.size, std::as_writable_bytes(std::span(bytes.values)));
        return bytes;
    }

    /// @param planes ascending
    [[nodiscard]] QString difference(const std::vector<Bytes>& planes,
        const std::bitset<256>& shown, const std::bitset<256>& translucent)
    {
        const Bytes seen = read(m_fixture->volume.shownLabels());
        Bytes members{seen.size, std::vector<std::uint8_t>(seen.values.size(), 0)};
        for (std::size_t i = 0; i < seen.values.size(); ++i) {
            std::uint8_t opaque = 0;
            std::uint8_t behind = 0;
            for (const Bytes& plane : planes) { // the highest comes last
                const std::uint8_t label = plane.values[i];
                if (!shown[label])
                    continue;
                members.values[i] = 255;
                (translucent[label] ? behind : opaque) = label;
            }
            const std::uint8_t expected = opaque != 0 ? opaque : behind;
            if (seen.values[i] != expected)
                return QStringLiteral("voxel %1 shows %2 instead of %3")
                    .arg(i)
                    .arg(seen.values[i])
                    .arg(expected);
        }
        if (read(m_fixture->volume.segmentation()).values != reference::radiation(members).values)
            return QStringLiteral("the segmentation map is another one");
        return {};
    }

private Q_SLOTS:
    void isWhatTheRuleSays_data()
    {
        QTest::addColumn<int>("count");
        for (int count = 2; count <= core::mostLabelPlanes; ++count)
            QTest::addRow("%d planes", count) << count;
    }

    void isWhatTheRuleSays()
    {
        QFETCH(int, count);
        std::mt19937 random(std::uint32_t(70 + count));
        const glm::ivec3 size{
            20 + int(random() % 20), 17 + int(random() % 20), 9 + int(random() % 20)};
        m_fixture->open(test::centredGeometry(size), [](const glm::dvec3&) { return 1000.0; });
        reference::DenseFields state(size);
        std::vector<Bytes> planes(std::size_t(count), Bytes{});
        const auto put = [&] {
            for (int plane = 0; plane < count; ++plane) {
                scatter(state.labels(std::uint8_t(plane)), random);
                planes[std::size_t(plane)] = state.labels(std::uint8_t(plane));
            }
            m_fixture->put(state);
        };
        put();
        QCOMPARE(int(m_fixture->volume.labelPlanes().size()), count);
        std::bitset<256> shown = someLabels(random);
        shown.set(1);
        std::bitset<256> translucent = someLabels(random) & shown;
        m_fixture->edits.fields->setShownLabels(shown, translucent);
        update();
        QString wrong = difference(planes, shown, translucent);
        QVERIFY2(wrong.isEmpty(), qPrintable(wrong));
        put();
        update();
        wrong = difference(planes, shown, translucent);
        QVERIFY2(wrong.isEmpty(), qPrintable(QStringLiteral("after an edit: ") + wrong));
        translucent = shown & ~translucent;
        m_fixture->edits.fields->setShownLabels(shown, translucent);
        update();
        wrong = difference(planes, shown, translucent);
        QVERIFY2(wrong.isEmpty(), qPrintable(QStringLiteral("other opacities: ") + wrong));
        shown = ~shown;
        shown.reset(0);
        translucent &= shown;
        m_fixture->edits.fields->setShownLabels(shown, translucent);
        update();
        wrong = difference(planes, shown, translucent);
        QVERIFY2(wrong.isEmpty(), qPrintable(QStringLiteral("others shown: ") + wrong));
    }

    /// With one plane nothing is composed, and opacities make no work.
    void onePlaneIsItself()
    {
        std::mt19937 random(5);
        const glm::ivec3 size(24, 20, 18);
        m_fixture->open(test::centredGeometry(size), [](const glm::dvec3&) { return 1000.0; });
        reference::DenseFields state(size);
        scatter(state.labels(0), random);
        m_fixture->put(state);
        const std::size_t bytes = m_fixture->edits.fields->bytes();
        QCOMPARE(m_fixture->volume.labelPlanes().size(), std::size_t(1));
        QVERIFY(&m_fixture->volume.shownLabels() == &m_fixture->volume.labels());
        std::bitset<256> shown;
        shown.set(1).set(2).set(3);
        m_fixture->edits.fields->setShownLabels(shown);
        update();
        m_fixture->edits.fields->setShownLabels(shown, shown);
        QVERIFY(!m_fixture->edits.fields->segmentationStale());
        QCOMPARE(m_fixture->edits.fields->bytes(), bytes);
        // Nobody makes a further plane by asking what it holds.
        VoxelFields& fields = *m_fixture->edits.fields;
        const std::vector<std::uint32_t> labelled = fields.labelledBricks();
        QVERIFY(!labelled.empty());
        const core::BrickKey further{core::Field::Labels, 1, labelled.front()};
        QVERIFY(fields.hasData({core::Field::Labels, 0, labelled.front()}));
        QVERIFY(!fields.hasData(further));
        QVERIFY(readImages(fields, std::span(&further, 1)).front().empty());
        QCOMPARE(fields.bytes(), bytes);
        QCOMPARE(m_fixture->volume.labelPlanes().size(), std::size_t(1));
        // A further plane costs itself, and what is seen of both.
        (void)m_fixture->edits.fields->labels(1);
        QCOMPARE(m_fixture->edits.fields->bytes(), bytes + 2 * m_fixture->volume.labels().bytes());
        QCOMPARE(m_fixture->volume.labelPlanes().size(), std::size_t(2));
        m_fixture->edits.fields.reset();
        QCOMPARE(m_fixture->volume.labelPlanes().size(), std::size_t(1));
    }
};

BURIN_TEST(ShownLabelsGlTest)

} // namespace shownLabelsGlTest

#include "ShownLabelsGlTest.moc"
