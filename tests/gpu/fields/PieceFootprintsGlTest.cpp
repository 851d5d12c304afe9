// SPDX-License-Identifier: Apache-2.0
#include "tests/reference/fields/Radiation.h"
#include "tests/support/faults/RefusingGl.h"
#include "tests/support/fixtures/frames/FrameTest.h"
#include "tests/support/program/TestProgram.h"

#include <QTest>

#include <algorithm>
#include <map>
#include <random>

namespace pieceFootprintsGlTest {

using namespace gpu;
using reference::DenseArray;

/// Footprints of pieces equal the oracle's radiation of what they are made of, to the bit, in
/// whole.
class PieceFootprintsGlTest : public test::FrameTest {
    Q_OBJECT

    using Bytes = DenseArray<std::uint8_t>;

    /// A few boxes of random coverage, thin ones among them.
    static void scatter(Bytes& bytes, std::mt19937& random)
    {
        const auto between = [&](int low, int high) {
            return low + int(random() % std::uint32_t(high - low + 1));
        };
        for (int i = between(1, 4); i > 0; --i) {
            glm::ivec3 low;
            glm::ivec3 high;
            for (int axis = 0; axis < 3; ++axis) {
                low[axis] = between(0, bytes.size[axis] - 1);
                high[axis] = std::min(low[axis] + between(1, 14), bytes.size[axis]);
            }
            const int value = between(0, 3) == 0 ? between(1, 254) : 255;
            for (int z = low.z; z < high.z; ++z)
                for (int y = low.y; y < high.y; ++y)
                    for (int x = low.x; x < high.x; ++x)
                        bytes.at({x, y, z}) = std::uint8_t(value);
        }
    }

    [[nodiscard]] QString difference(const PieceSource& source, const Bytes& truth)
    {
        while (m_fixture->edits.work()) { }
        const PieceTextures& pieces = m_fixture->volume.pieces();
        const PieceTextures::Entry* entry = pieces.entry(source);
        const Bytes expected = reference::radiation(truth);
        std::vector<std::uint8_t> texels;
        glm::ivec3 room(0);
        if (entry) {
            room = entry->box.maximum - entry->box.minimum;
            texels.resize(std::size_t(room.x) * std::size_t(room.y) * std::size_t(room.z));
            pieces.footprints().read(entry->place, room, std::as_writable_bytes(std::span(texels)));
        }
        for (int z = 0; z < truth.size.z; ++z) {
            for (int y = 0; y < truth.size.y; ++y) {
                for (int x = 0; x < truth.size.x; ++x) {
                    const glm::ivec3 voxel(x, y, z);
                    int here = 0;
                    if (entry && glm::all(glm::greaterThanEqual(voxel, entry->box.minimum))
                        && glm::all(glm::lessThan(voxel, entry->box.maximum))) {
                        const glm::ivec3 at = voxel - entry->box.minimum;
                        here = texels[std::size_t(at.x + room.x * (at.y + room.y * at.z))];
                    }
                    const int there = expected.at(voxel);
                    // A cell that is not looked at must have nothing that could be seen.
                    const bool seen = entry
                        && glm::all(glm::greaterThanEqual(voxel, entry->filled.minimum))
                        && glm::all(glm::lessThan(voxel, entry->filled.maximum));
                    if (here != there || (there >= 128 && !seen))
                        return QStringLiteral("voxel %1 %2 %3: %4 instead of %5%6")
                            .arg(x)
                            .arg(y)
                            .arg(z)
                            .arg(here)
                            .arg(there)
                            .arg(seen ? QString() : QStringLiteral(", not looked at"));
                }
            }
        }
        return {};
    }

private Q_SLOTS:
    void followTheirLayers()
    {
        std::mt19937 random(11);
        const int rounds = qEnvironmentVariableIsSet("BURIN_LONG") ? 40 : 5;
        for (int round = 0; round < rounds; ++round) {
            const glm::ivec3 size{
                20 + int(random() % 40), 17 + int(random() % 30), 9 + int(random() % 30)};
            m_fixture->open(test::centredGeometry(size), [](const glm::dvec3&) { return 1000.0; });
            reference::DenseFields state(size);
            for (const int layer : {1, 2, 3})
                scatter(state.coverage(std::uint8_t(layer)), random);
            scatter(state.labels(0), random);
            if (round % 2 == 1) // a segment may lie in any plane
                scatter(state.labels(1), random);
            m_fixture->put(state);
            const PieceSource second{.layer = 2};
            const PieceSource third{.layer = 3};
            const PieceSource label{.segment = 255};
            m_fixture->edits.showPieces({label, second, third});

            const auto made = [&](int layer, const std::bitset<256>& muted) {
                Bytes truth = state.coverage(std::uint8_t(layer));
                for (int before = 1; before < layer; ++before) {
                    const Bytes& other = state.coverage(std::uint8_t(before));
                    for (std::size_t i = 0; i < truth.values.size(); ++i) {
                        if (!muted[std::size_t(before)])
                            truth.values[i] = std::min<std::uint8_t>(
                                truth.values[i], std::uint8_t(255 - other.values[i]));
                    }
                }
                return truth;
            };
            const auto bearers = [&] {
                Bytes truth{size, std::vector<std::uint8_t>(state.labels(0).values.size(), 0)};
                for (const auto& [plane, labels] : state.labelPlanes()) {
                    for (std::size_t i = 0; i < truth.values.size(); ++i) {
                        if (labels->values[i] == 255)
                            truth.values[i] = 255;
                    }
                }
                return truth;
            };
            const auto check = [&](const std::bitset<256>& muted) {
                QString wrong = difference(second, made(2, muted));
                if (wrong.isEmpty())
                    wrong = difference(third, made(3, muted));
                return wrong.isEmpty() ? difference(label, bearers()) : wrong;
            };
            QString wrong = check({});
            QVERIFY2(wrong.isEmpty(), qPrintable(wrong));
            // More is cut and painted, beyond the room that was made.
            for (const int layer : {1, 2, 3})
                scatter(state.coverage(std::uint8_t(layer)), random);
            scatter(state.labels(0), random);
            m_fixture->put(state);
            wrong = check({});
            QVERIFY2(wrong.isEmpty(), qPrintable(QStringLiteral("later: ") + wrong));
            std::bitset<256> muted;
            muted.set(1);
            m_fixture->edits.fields->setMutedLayers(muted);
            wrong = check(muted);
            QVERIFY2(wrong.isEmpty(), qPrintable(QStringLiteral("muted: ") + wrong));
        }
    }

    /// Where there is no memory for them, pictures and edits go on without pieces, and nothing is
    /// tried with every edit. When other pieces are shown, they are there again.
    void nothingElseSuffersWhereTheyAreRefused()
    {
        const glm::ivec3 size(40, 36, 30);
        m_fixture->open(test::centredGeometry(size), [](const glm::dvec3&) { return 1000.0; });
        reference::DenseFields state(size);
        std::mt19937 random(5);
        scatter(state.coverage(1), random);
        m_fixture->put(state);
        const PieceSource source{.layer = 1};
        {
            const test::RefusingGl refusing(1, test::RefusingGl::From::OnAndOn);
            m_fixture->edits.showPieces({source});
            while (m_fixture->edits.work()) { }
            QVERIFY(refusing.refused() > 0);
        }
        QVERIFY(!m_fixture->volume.pieces().entry(source));
        scatter(state.coverage(1), random);
        m_fixture->put(state);
        QVERIFY(!m_fixture->edits.fields->piecesStale());

        VolumeScene scene;
        scene.heightMm = 60.0;
        scene.surfaceThreshold = 500.0;
        scene.pieces = {ScenePiece{.id = 1, .layer = 1}};
        const Frame frame = m_fixture->draw(scene, {60, 50});
        QVERIFY(!frame.failure);
        QCOMPARE(frame.quality, Frame::Quality::Refined);
        QVERIFY(frame.pieces.empty());

        m_fixture->edits.showPieces({});
        m_fixture->edits.showPieces({source});
        const QString wrong = difference(source, state.coverage(1));
        QVERIFY2(wrong.isEmpty(), qPrintable(wrong));
        QVERIFY(m_fixture->volume.pieces().entry(source));
        QVERIFY(newErrors() > 0);
    }

    /// Long boxes lie on, beside and behind each other, wherever a texture has room.
    void boxesUseTheWholeTexture()
    {
        GLint longest = 0;
        glGetIntegerv(GL_MAX_3D_TEXTURE_SIZE, &longest);
        if (longest > 4096)
            QSKIP("textures are so long here that these would take gigabytes");
        const int half = longest / 16 * 8 + 8; // two of them are longer than a texture
        std::map<PieceSource, core::VoxelBox> boxes;
        for (const int layer : {1, 2, 3})
            boxes[{.layer = layer}] = {glm::ivec3(0), {half, 8 * layer, half}};
        PieceTextures pieces;
        pieces.arrange(boxes);
        for (const auto& [source, box] : boxes) {
            const PieceTextures::Entry* entry = pieces.entry(source);
            QVERIFY(entry);
            const glm::ivec3 end = entry->place + box.maximum;
            QVERIFY(glm::all(glm::lessThanEqual(end, pieces.footprints().size())));
            for (const auto& [other, room] : pieces.entries()) {
                const glm::ivec3 otherEnd = room.place + room.box.maximum;
                const bool isApart = glm::any(glm::lessThanEqual(end, room.place))
                    || glm::any(glm::lessThanEqual(otherEnd, entry->place));
                QVERIFY(source == other || isApart);
            }
        }
    }
};

BURIN_TEST(PieceFootprintsGlTest)

} // namespace pieceFootprintsGlTest

#include "PieceFootprintsGlTest.moc"
