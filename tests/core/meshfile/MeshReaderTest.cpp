// SPDX-License-Identifier: Apache-2.0
#include "core/meshfile/MeshReader.h"
#include "tests/support/program/TestProgram.h"

#include <QDataStream>
#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include <cstring>

namespace meshReaderTest {

namespace {

/// A tetrahedron in each of the forms that programs write.
QByteArray textStl()
{
    QByteArray text("solid liver part SPACE=RAS\n");
    const char* corners[4] = {"0 0 0", "4.5e0 0 0", "0 4 0", "0 0 +4"};
    const int faces[4][3] = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}};
    for (const auto& face : faces) {
        text += "  facet normal 0 0 0\r\n    outer loop\r\n";
        for (const int corner : face)
            text += QByteArray("      vertex ") + corners[corner] + "\r\n";
        text += "    endloop\r\n  endfacet\r\n";
    }
    return text + "endsolid liver\n";
}

QByteArray binaryStl(const char* head)
{
    QByteArray bytes(head);
    bytes.resize(80, '\0');
    QDataStream out(&bytes, QIODevice::Append);
    out.setByteOrder(QDataStream::LittleEndian);
    out.setFloatingPointPrecision(QDataStream::SinglePrecision);
    out << quint32(1);
    for (int i = 0; i < 12; ++i)
        out << float(i);
    out << quint16(0);
    return bytes;
}

QByteArray bigEndianPly()
{
    QByteArray bytes("ply\nformat binary_big_endian 1.0\nobj_info made by hand\nelement vertex 4\n"
                     "property double x\nproperty double y\nproperty double z\nproperty uchar red\n"
                     "property uchar green\nproperty uchar blue\nproperty uchar alpha\n"
                     "element face 1\nproperty short quality\n"
                     "property list ushort int vertex_index\nelement edge 0\nproperty int v\n"
                     "end_header\n");
    QDataStream out(&bytes, QIODevice::Append);
    for (const auto& [x, y] : {std::pair(0, 0), std::pair(2, 0), std::pair(2, 2), std::pair(0, 2)})
        out << double(x) << double(y) << 1.5 << quint8(200) << quint8(100) << quint8(50)
            << quint8(255);
    out << qint16(7) << quint16(4);
    for (const int corner : {0, 1, 2, 3})
        out << qint32(corner);
    return bytes;
}

const QByteArray textPly("ply\nformat ascii 1.0\ncomment SPACE=LPS by hand\nelement vertex 3\n"
                         "property float x\nproperty float y\nproperty float z\nelement face 1\n"
                         "property list uchar int vertex_indices\nend_header\n"
                         "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");

core::Result<core::ReadMesh> readAs(const char* name, const QByteArray& bytes)
{
    static const QTemporaryDir folder;
    const QString path = folder.filePath(QLatin1String(name));
    QFile file(path);
    if (!file.open(QIODevice::WriteOnly) || file.write(bytes) != bytes.size())
        qFatal("not written");
    file.close();
    return core::readMesh(path);
}

} // namespace

/// What other programs write; of Burin's own files see ExportSurfaceTest.
class MeshReaderTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void stlAsText()
    {
        const auto mesh = readAs("a.stl", textStl() + textStl());
        QVERIFY(mesh);
        QCOMPARE(mesh->space, QStringLiteral("RAS"));
        QCOMPARE(mesh->parts.size(), std::size_t(2));
        QCOMPARE(mesh->parts[1].name, QStringLiteral("liver part"));
        QCOMPARE(mesh->parts[1].triangles.size(), std::size_t(4));
        QVERIFY(mesh->parts[0].vertices[2] == glm::vec3(4.5F, 0, 0));
    }

    /// Some programs begin binary files so, too.
    void binaryStlThatBeginsAsText()
    {
        for (const char* head : {"solid by somebody facet", "SPACE=LPS"}) {
            const auto mesh = readAs("b.stl", binaryStl(head));
            QVERIFY(mesh);
            QCOMPARE(mesh->parts.front().triangles.size(), std::size_t(1));
            QVERIFY(mesh->parts.front().vertices[2] == glm::vec3(9, 10, 11));
        }
    }

    void objWithGroupsPolygonsAndRelativePoints()
    {
        const auto mesh = readAs("a.obj",
            "mtllib x.mtl\n#c SPACE=RAS\n\ng first\nv 0 0 0\nv 1 0 0 1 0.5 0\r\nv 1 1 0\nv 0 1 0\n"
            "vn 0 0 1\nvt 0 0\nusemtl m\ns off\nf 1/1/1 2/1/1 3/1/1 4//1\ng second\n"
            "v 9 9 9\nf -1 -2 -3\n");
        QVERIFY(mesh);
        QCOMPARE(mesh->space, QStringLiteral("RAS"));
        QCOMPARE(mesh->parts.size(), std::size_t(2));
        QCOMPARE(mesh->parts[0].name, QStringLiteral("first"));
        QCOMPARE(mesh->parts[0].triangles.size(), std::size_t(2));
        QCOMPARE(mesh->parts[1].vertices.size(), std::size_t(3));
        QVERIFY(mesh->parts[1].vertices[0] == glm::vec3(9));
        QVERIFY(!mesh->parts[0].rgb);
    }

    void plyOfEitherKind()
    {
        const auto text = readAs("a.ply", textPly);
        QVERIFY(text);
        QCOMPARE(text->space, QStringLiteral("LPS"));
        QCOMPARE(text->parts.front().triangles.size(), std::size_t(1));
        const auto binary = readAs("b.ply", bigEndianPly());
        QVERIFY(binary);
        QCOMPARE(binary->parts.front().triangles.size(), std::size_t(2));
        QVERIFY(binary->parts.front().vertices[2] == glm::vec3(2, 2, 1.5F));
        QCOMPARE(binary->parts.front().rgb.value_or(0), 0xc86432U);
    }

    void faultyFiles_data()
    {
        QTest::addColumn<QByteArray>("name");
        QTest::addColumn<QByteArray>("bytes");
        const auto row = [](const char* what, const char* name, const QByteArray& bytes) {
            QTest::newRow(what) << QByteArray(name) << bytes;
        };
        for (const char* name : {"e.stl", "e.obj", "e.ply", "e.glb"})
            row(name, name, {});
        row("STL: cut", "a.stl", binaryStl("x").chopped(1));
        row("STL: counts too much", "a.stl", binaryStl("x").replace(80, 4, "\xff\xff\xff\xff"));
        float nan = NAN;
        QByteArray lost = binaryStl("x");
        std::memcpy(lost.data() + 100, &nan, 4);
        row("STL: a corner nowhere", "a.stl", lost);
        row("STL: text that ends early", "a.stl", textStl().left(200) + "\nfacet");
        row("STL: a word for a number", "a.stl", textStl().replace("0 4 0", "0 x 0"));
        row("OBJ: point 0", "a.obj", "v 0 0 0\nf 0 1 1\n");
        row("OBJ: points not there", "a.obj", "v 0 0 0\nf 1 2 3\n");
        row("OBJ: half a point", "a.obj", "v 0 0 0\nf 1 1.5 1\n");
        row("OBJ: not a number", "a.obj", "v 0 nan 0\nf 1 1 1\n");
        row("OBJ: two corners", "a.obj", "v 0 0 0\nf 1 1\n");
        row("PLY: header without end", "a.ply", textPly.left(80));
        row("PLY: fewer points", "a.ply", QByteArray(textPly).replace("vertex 3", "vertex 4"));
        row("PLY: very many points", "a.ply",
            QByteArray(textPly).replace("vertex 3", "vertex 2000000000"));
        row("PLY: too many points", "a.ply",
            QByteArray(textPly).replace("vertex 3", "vertex 99999999999999"));
        row("PLY: negative", "a.ply", QByteArray(textPly).replace("vertex 3", "vertex -3"));
        row("PLY: points not there", "a.ply", QByteArray(textPly).replace("3 0 1 2", "3 0 1 3"));
        row("PLY: an endless face", "a.ply",
            QByteArray(textPly).replace("uchar int", "double int").replace("3 0 1 2", "1e300 0 1"));
        row("PLY: no place", "a.ply", QByteArray(textPly).replace("float z", "float w"));
        row("PLY: unknown numbers", "a.ply", QByteArray(textPly).replace("float z", "half z"));
        row("PLY: segments of faces that are not there", "a.ply",
            QByteArray(textPly).replace("comment SPACE=LPS by hand",
                "comment segment 1 faces 0 to 4000000000000000000: all"));
        row("PLY: cut", "b.ply", bigEndianPly().chopped(1));
    }

    void faultyFiles()
    {
        QFETCH(QByteArray, name);
        QFETCH(QByteArray, bytes);
        const auto mesh = readAs(name.constData(), bytes);
        QVERIFY(!mesh);
        QVERIFY(mesh.error().arguments.value(0).endsWith(QLatin1String(name)));
        QVERIFY(!mesh.error().arguments.value(1).isEmpty());
    }

    /// No byte of a file may do more than make it unreadable.
    void anyByteMayBeWrong()
    {
        std::uint32_t random = 7;
        const auto next = [&random] {
            return random = random * 1664525U + 1013904223U, random >> 8U;
        };
        const std::pair<const char*, QByteArray> files[] = {{"f.stl", textStl()},
            {"f.stl", binaryStl("x")}, {"f.ply", textPly}, {"f.ply", bigEndianPly()},
            {"f.obj", "o a\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"}};
        int read = 0;
        for (int i = 0; i < 4000; ++i) {
            auto [name, bytes] = files[i % 5];
            for (int k = 0; k < 1 + i % 3; ++k)
                bytes[qsizetype(next() % unsigned(bytes.size()))] = char(next());
            read += readAs(name, bytes) ? 1 : 0;
        }
        QVERIFY(read > 100);
    }
};

BURIN_TEST(MeshReaderTest)

} // namespace meshReaderTest

#include "MeshReaderTest.moc"
