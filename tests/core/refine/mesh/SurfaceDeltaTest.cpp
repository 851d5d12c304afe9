// SPDX-License-Identifier: Apache-2.0
#include "core/refine/mesh/SurfaceDelta.h"
#include "tests/support/program/LongRun.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/SimplexShapes.h"

#include <QTest>
#include <QtEndian>

#include <bit>

namespace surfaceDeltaTest {

namespace {

core::SimplexMesh ballAndRing()
{
    return test::simplexMesh(test::together(
        test::icosphere(10.0, 1), test::moved(test::torus(8.0, 3.0, 9, 5), {30, 0, 0})));
}

/// Structure, places and marks.
core::SimplexMeshDelta changed(core::SimplexMesh& mesh, test::Random& random)
{
    core::SimplexMeshEdit edit(mesh);
    for (int i = test::randomInt(random, 1, 12); i > 0; --i) {
        test::randomOperation(edit, random);
        const auto ids = mesh.vertexIds();
        const core::VertexId id = ids[std::size_t(test::randomInt(random, 0, int(ids.size()) - 1))];
        edit.move(id, mesh.position(id) + glm::dvec3(test::randomUnit(random), -0.0, 1e-300));
        edit.setMark(id, i % 2 == 0 ? core::SurfaceMark::Red : core::SurfaceMark::Yellow);
    }
    return edit.commit();
}

/// A tetrahedron with numbers in all of its places.
core::SimplexMesh tetrahedron()
{
    return *core::SimplexMesh::make({{0, -0.0, 1.5}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
        {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}});
}

} // namespace

/// Changes of surfaces as bytes.
class SurfaceDeltaTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void thereAndBack();
    void theFormIsWhatItIs();
    void whatIsListedMayHaveStayed();
    void theHashTellsMeshesApart();
    void truncationsAndFlippedBytes();
    void countsPromiseNoMemory();
    void onlyWhatFitsIsApplied();
};

void SurfaceDeltaTest::thereAndBack()
{
    auto random = test::Random(31);
    core::SimplexMesh mesh = ballAndRing();
    core::SimplexMesh other = ballAndRing();
    std::vector<QByteArray> entries;
    std::vector<QByteArray> hashes{core::sha256Of(mesh)};
    for (int i = 0; i < (test::longRun() ? 500 : 60); ++i) {
        const core::SimplexMeshDelta delta = changed(mesh, random);
        entries.push_back(core::packed(delta));
        hashes.push_back(core::sha256Of(mesh));
        const auto read = core::unpackedSurfaceDelta(entries.back());
        QVERIFY(read.has_value());
        QCOMPARE(core::packed(*read), entries.back());
        QVERIFY(core::canRedo(*read, other));
        read->redo(other);
        QVERIFY(core::identical(mesh, other));
    }
    for (std::size_t i = entries.size(); i-- > 0;) {
        const auto read = core::unpackedSurfaceDelta(entries[i]);
        QVERIFY(read && core::canUndo(*read, other));
        read->undo(other);
        QCOMPARE(core::sha256Of(other), hashes[i]);
    }
    QVERIFY(core::identical(other, ballAndRing()));
    // All of a mesh, with ids that are free in between.
    const auto whole = core::unpackedSurfaceDelta(core::packed(core::deltaFromNothing(mesh)));
    core::SimplexMesh made;
    QVERIFY(whole && core::canRedo(*whole, made));
    whole->redo(made);
    QVERIFY(core::identical(made, mesh));
    QVERIFY(core::unpackedSurfaceDelta(core::packed({}))->empty());
}

void SurfaceDeltaTest::theFormIsWhatItIs()
{
    core::SimplexMesh mesh = tetrahedron();
    core::SimplexMeshEdit edit(mesh);
    edit.move(0, {0, 0.0, 1.5});
    edit.setMark(2, core::SurfaceMark::Red);
    const core::SimplexMeshDelta delta = edit.commit();
    const QByteArray bytes = core::packed(delta);
    QCOMPARE(bytes.size(), qsizetype(12 + 2 * (5 + 2 * 49)));
    QVERIFY(bytes.startsWith("MDL1"));
    QCOMPARE(qFromLittleEndian<quint32>(bytes.constData() + 4), 2U);
    QCOMPARE(qFromLittleEndian<quint32>(bytes.constData() + 8), 0U);
    QCOMPARE(int(bytes[16]), 3);
    QCOMPARE(qFromLittleEndian<quint64>(bytes.constData() + 17 + 8), quint64(1) << 63);
    QCOMPARE(qFromLittleEndian<quint64>(bytes.constData() + 17 + 49 + 8), quint64(1) << 63);
    QCOMPARE(qFromLittleEndian<quint64>(bytes.constData() + 17 + 49 + 16), quint64(0));
    QCOMPARE(int(bytes.back()), int(core::SurfaceMark::Red));
    QCOMPARE(core::sha256Of(tetrahedron()),
        QByteArray("05c00e04bbe7731b282be6334e64884463056ae49a1a8278ff433ccf3ae43f22"));
}

/// Sessions of earlier versions have such rows: a surface that was laid again where it was.
void SurfaceDeltaTest::whatIsListedMayHaveStayed()
{
    core::SimplexMesh mesh = tetrahedron();
    core::SimplexMeshDelta stayed;
    for (const core::VertexId id : mesh.vertexIds())
        stayed.vertices.push_back({.id = id, .before = mesh.vertex(id), .after = mesh.vertex(id)});
    for (const core::FaceId id : mesh.faceIds())
        stayed.faces.push_back({.id = id, .before = mesh.ring(id), .after = mesh.ring(id)});
    const QByteArray bytes = core::packed(stayed);
    const auto read = core::unpackedSurfaceDelta(bytes);
    QVERIFY(read);
    QCOMPARE(core::packed(*read), bytes);
    QVERIFY(core::canRedo(*read, mesh) && core::canUndo(*read, mesh));
    read->redo(mesh);
    QVERIFY(core::identical(mesh, tetrahedron()));
    read->undo(mesh);
    QVERIFY(core::identical(mesh, tetrahedron()));
}

void SurfaceDeltaTest::theHashTellsMeshesApart()
{
    const QByteArray hash = core::sha256Of(tetrahedron());
    core::SimplexMesh mesh = tetrahedron();
    {
        core::SimplexMeshEdit edit(mesh);
        edit.move(0, {0, 0.0, 1.5});
        QVERIFY(core::sha256Of(mesh) != hash);
    }
    QCOMPARE(core::sha256Of(mesh), hash);
    {
        core::SimplexMeshEdit edit(mesh);
        edit.setMark(3, core::SurfaceMark::Green);
        QVERIFY(core::sha256Of(mesh) != hash);
    }
    QVERIFY(core::sha256Of({}) != hash);
    // A ring that begins elsewhere is another: what comes after would differ.
    const auto turned = core::SimplexMesh::make({{0, -0.0, 1.5}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
        {{2, 1, 0}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}});
    QVERIFY(turned && core::sha256Of(*turned) != hash);
}

void SurfaceDeltaTest::truncationsAndFlippedBytes()
{
    auto random = test::Random(32);
    core::SimplexMesh mesh = ballAndRing();
    const QByteArray bytes = core::packed(changed(mesh, random));
    for (qsizetype size = 0; size < bytes.size(); ++size)
        QVERIFY(!core::unpackedSurfaceDelta(bytes.first(size)));
    QVERIFY(!core::unpackedSurfaceDelta(bytes + QByteArray(1, '\0')));
    int taken = 0;
    const int trials = test::longRun() ? 200'000 : 20'000;
    for (int trial = 0; trial < trials; ++trial) {
        QByteArray other = bytes;
        for (int i = test::randomInt(random, 1, 3); i > 0; --i) {
            const int at = test::randomInt(random, 0, int(other.size()) - 1);
            other[at] = char(other[at] ^ (1 << test::randomInt(random, 0, 7)));
        }
        const auto read = core::unpackedSurfaceDelta(other);
        if (!read)
            continue;
        ++taken;
        // There is one form only, so none reads as another.
        QCOMPARE(core::packed(*read), other);
    }
    QVERIFY(taken > 0 && taken < trials);
}

void SurfaceDeltaTest::countsPromiseNoMemory()
{
    const auto claims = [](quint32 vertices, quint32 faces, const QByteArray& rest) {
        QByteArray bytes("MDL1");
        bytes.resize(12);
        qToLittleEndian(vertices, bytes.data() + 4);
        qToLittleEndian(faces, bytes.data() + 8);
        return bytes + rest;
    };
    QVERIFY(core::unpackedSurfaceDelta(claims(0, 0, {})).has_value());
    QVERIFY(!core::unpackedSurfaceDelta(claims(0xFFFFFFFF, 0, {})));
    QVERIFY(!core::unpackedSurfaceDelta(claims(0, 0xFFFFFFFF, {})));
    QVERIFY(!core::unpackedSurfaceDelta(claims(0xFFFFFFFF, 0xFFFFFFFF, QByteArray(200, '\1'))));
    // A ring that says it has four thousand million vertices.
    QByteArray face(24, '\0');
    face[4] = char(0xFF);
    face[7] = char(0xFF);
    QVERIFY(!core::unpackedSurfaceDelta(claims(0, 1, face)));
    // An id out of the way, which a mesh would make room for.
    face = QByteArray(24, '\0');
    face[8] = 3;
    QVERIFY(core::unpackedSurfaceDelta(claims(0, 1, face)).has_value());
    face[3] = 1;
    QVERIFY(!core::unpackedSurfaceDelta(claims(0, 1, face)));
}

void SurfaceDeltaTest::onlyWhatFitsIsApplied()
{
    auto random = test::Random(33);
    core::SimplexMesh mesh = ballAndRing();
    const core::SimplexMesh before = mesh;
    const core::SimplexMeshDelta delta = changed(mesh, random);
    QVERIFY(core::canRedo(delta, before) && !core::canRedo(delta, mesh));
    QVERIFY(core::canUndo(delta, mesh) && !core::canUndo(delta, before));
    QVERIFY(!core::canRedo(delta, core::SimplexMesh()));
    QVERIFY(core::canRedo({}, core::SimplexMesh()));
}

BURIN_TEST(SurfaceDeltaTest)

} // namespace surfaceDeltaTest

#include "SurfaceDeltaTest.moc"
