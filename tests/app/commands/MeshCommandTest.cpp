// SPDX-License-Identifier: Apache-2.0
#include "core/meshfile/MeshReader.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/series/VolumeFiles.h"
#include "tests/support/servers/BurinProgram.h"

#include <QTest>

#include <cmath>

namespace meshCommandTest {

namespace {

constexpr int edge = 40;

QByteArray header(const char* more)
{
    return QByteArray("NRRD0004\ntype: unsigned char\ndimension: 3\nsizes: 40 40 40\n"
                      "space: left-posterior-superior\n"
                      "space directions: (1,0,0) (0,1,0) (0,0,1.5)\nspace origin: (-20,-10,5)\n")
        + more + "encoding: raw\n\n";
}

/// Label 1 in a ball of 12 voxels, in mm: 12 wide, 18 high.
QByteArray ball()
{
    QByteArray labels(edge * edge * edge, '\0');
    for (int z = 0; z < edge; ++z) {
        for (int y = 0; y < edge; ++y) {
            for (int x = 0; x < edge; ++x) {
                const double off = std::hypot(double(x) - 19.5, double(y) - 19.5, double(z) - 19.5);
                if (off < 12.0)
                    labels[(z * edge + y) * edge + x] = 1;
            }
        }
    }
    return labels;
}

} // namespace

/// `burin mesh`: the surface of a mask as a file, what it is worth, and where it fails.
class MeshCommandTest : public QObject, test::VolumeFiles {
    Q_OBJECT

    QString m_study;
    QString m_mask;

    [[nodiscard]] test::Outcome mesh(const QStringList& more) const
    {
        return test::burin(
            QStringList{QStringLiteral("mesh"), m_mask, QStringLiteral("--study"), m_study} + more);
    }

private Q_SLOTS:
    void init()
    {
        makeFolder();
        m_study = put(QStringLiteral("study.nrrd"), header("") + ball());
        m_mask = put(QStringLiteral("mask.nrrd"), header("") + ball());
    }

    void everyFormat_data()
    {
        QTest::addColumn<QString>("file");
        for (const char* ending : {"ply", "stl", "obj", "glb"})
            QTest::newRow(ending) << QStringLiteral("surface.") + QLatin1String(ending);
    }

    void everyFormat()
    {
        QFETCH(const QString, file);
        const QString out = m_folder->filePath(file);
        const test::Outcome outcome = mesh({QStringLiteral("--out"), out,
            QStringLiteral("--vertices"), QStringLiteral("3000"), QStringLiteral("--json")});
        QCOMPARE(outcome.status, 0);
        const QJsonObject facts = outcome.lines.value(0);
        const double voxels = facts.value(QStringLiteral("voxels")).toDouble();
        QVERIFY(voxels > 7000.0);
        // The way there and back: below half a per cent.
        const double inside = facts.value(QStringLiteral("meshVoxels")).toDouble();
        QVERIFY2(std::abs(inside - voxels) <= 0.005 * voxels, qPrintable(QString::number(inside)));
        QVERIFY(facts.value(QStringLiteral("sharedVoxels")).toDouble() > 0.995 * voxels);
        QVERIFY(std::abs(facts.value(QStringLiteral("volumeMm3")).toDouble() / (1.5 * voxels) - 1.0)
            < 0.01);
        QCOMPARE(facts.value(QStringLiteral("parts")).toInt(), 1);
        QCOMPARE(facts.value(QStringLiteral("crossings")).toInt(), 0);
        const double vertices = facts.value(QStringLiteral("vertices")).toDouble();
        QVERIFY(vertices > 2000.0 && vertices < 4500.0);
        const auto read = core::readMesh(out);
        QVERIFY(read);
        QCOMPARE(read->parts.size(), std::size_t(1));
        // Three edges a vertex of the surface, two triangles an edge.
        QCOMPARE(double(read->parts.front().triangles.size()), 3.0 * vertices);
    }

    /// As the window lays it: as few vertices as it takes, and nothing passes through itself.
    void byTheNewestRules()
    {
        const test::Outcome outcome = mesh({QStringLiteral("--out"),
            m_folder->filePath(QStringLiteral("a.ply")), QStringLiteral("--json")});
        QCOMPARE(outcome.status, 0);
        const QJsonObject facts = outcome.lines.value(0);
        const int vertices = facts.value(QStringLiteral("vertices")).toInt();
        QVERIFY2(vertices > 1000 && vertices < 5000, qPrintable(QString::number(vertices)));
        QCOMPARE(facts.value(QStringLiteral("crossings")).toInt(), 0);
    }

    void otherSpace()
    {
        const QString lps = m_folder->filePath(QStringLiteral("lps.stl"));
        const QString ras = m_folder->filePath(QStringLiteral("ras.stl"));
        QCOMPARE(mesh({QStringLiteral("--out"), lps}).status, 0);
        QCOMPARE(
            mesh({QStringLiteral("--out"), ras, QStringLiteral("--space"), QStringLiteral("ras")})
                .status,
            0);
        const auto one = core::readMesh(lps);
        const auto other = core::readMesh(ras);
        QVERIFY(one && other);
        QCOMPARE(one->parts.front().vertices.size(), other->parts.front().vertices.size());
        const glm::dvec3 turned =
            glm::dvec3(-1, -1, 1) * glm::dvec3(one->parts.front().vertices.front());
        const glm::dvec3 read(other->parts.front().vertices.front());
        QVERIFY(glm::distance(turned, read) < 1e-4);
    }

    /// Where the study does not say how large its voxels are, nobody has measured millilitres.
    void noVolumeOfUnknownVoxels()
    {
        const QByteArray unknown =
            "NRRD0004\ntype: unsigned char\ndimension: 3\nsizes: 40 40 40\nencoding: raw\n\n";
        m_study = put(QStringLiteral("study.nrrd"), unknown + ball());
        m_mask = put(QStringLiteral("mask.nrrd"), unknown + ball());
        const QStringList words{QStringLiteral("--out"),
            m_folder->filePath(QStringLiteral("a.ply")), QStringLiteral("--force")};
        const test::Outcome facts = mesh(words + QStringList{QStringLiteral("--json")});
        QCOMPARE(facts.status, 0);
        QVERIFY(facts.lines.value(0).contains(QStringLiteral("volumeMm3")));
        QVERIFY(facts.lines.value(0).value(QStringLiteral("volumeMm3")).isNull());
        const test::Outcome told = mesh(words);
        QCOMPARE(told.status, 0);
        QVERIFY2(told.output.contains("1 part\n"), told.output.constData());
        QVERIFY2(!told.output.contains("mL"), told.output.constData());
    }

    void refusals_data()
    {
        QTest::addColumn<QStringList>("words");
        QTest::addColumn<int>("status");
        QTest::addColumn<QString>("told");
        const QString out = QStringLiteral("--out");
        QTest::newRow("no file") << QStringList{} << 2 << QStringLiteral("--out");
        QTest::newRow("another format")
            << QStringList{out, QStringLiteral("a.vtk")} << 2 << QStringLiteral(".ply");
        QTest::newRow("too few vertices") << QStringList{out, QStringLiteral("a.ply"),
            QStringLiteral("--vertices"), QStringLiteral("12")}
                                          << 2 << QStringLiteral("--vertices");
        QTest::newRow("no such segment") << QStringList{out, QStringLiteral("a.ply"),
            QStringLiteral("--segment"), QStringLiteral("Spleen")}
                                         << 1 << QStringLiteral("Spleen");
    }

    void refusals()
    {
        QFETCH(const QStringList, words);
        QFETCH(const int, status);
        QFETCH(const QString, told);
        const test::Outcome outcome = mesh(words);
        QCOMPARE(outcome.status, status);
        QVERIFY2(outcome.complaint.contains(told), qPrintable(outcome.complaint));
    }

    void aFileIsNotOverwritten()
    {
        const QString out = put(QStringLiteral("there.ply"), "mine");
        const test::Outcome outcome = mesh({QStringLiteral("--out"), out});
        QCOMPARE(outcome.status, 1);
        QVERIFY(outcome.complaint.contains(QStringLiteral("there.ply")));
        // Before anything was worked out.
        QVERIFY2(outcome.output.isEmpty(), outcome.output.constData());
        QCOMPARE(mesh({QStringLiteral("--out"), out, QStringLiteral("--force")}).status, 0);
        // Nor what is read, whatever is said.
        for (const QString& read : {out, QFileInfo(out).path()}) {
            m_mask = read;
            const test::Outcome refused =
                mesh({QStringLiteral("--out"), out, QStringLiteral("--force")});
            QCOMPARE(refused.status, 1);
            QVERIFY2(refused.complaint.contains(QStringLiteral("there.ply")),
                qPrintable(refused.complaint));
        }
    }
};

BURIN_TEST(MeshCommandTest)

} // namespace meshCommandTest

#include "MeshCommandTest.moc"
