// SPDX-License-Identifier: Apache-2.0
#include "core/edits/kinds/chunks/ChunkToggle.h"
#include "core/edits/kinds/chunks/DivideSegment.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/fixtures/CommandFixture.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/SmallStudy.h"
#include "tests/support/series/NrrdFiles.h"

#include <QFile>
#include <QJsonDocument>
#include <QTest>

namespace runChunksGlTest {

using namespace core;
using test::burin;
using test::key;
using test::Outcome;

/// `burin run` with edits that divide into chunks and click on them.
class RunChunksGlTest : public QObject, protected test::CommandFixture {
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { QVERIFY(prepareStudy()); }
    void init()
    {
        test::failOnUnexpectedMessages();
        makeFolder();
    }

    void theBoneComesWithAClick()
    {
        ChunkToggle click{.segment = 1, .chunks = 3, .pointsLps = test::pointsInBone()};
        const std::vector<Edit> edits{test::addSegment("Head"), test::seedInBrain(1),
            test::growBrain(), DivideSegment{.segment = 1, .marginMm = 6.0}, click};
        const Outcome made =
            run(recipe("make.json", {{key("edits"), test::toJson(edits)}}), "a.burin");
        QVERIFY2(made.status == 0, qPrintable(made.complaint));
        const QJsonArray rows = history("a.burin")[key("commands")].toArray();
        QCOMPARE(rows.size(), qsizetype(edits.size()));
        QCOMPARE(rows[3].toObject()[key("voxels")].toInt(-1), 0);
        // The shell between 11 and 15 mm, in voxels of 1.5 mm³, but for what lies beyond the box.
        const int voxels = rows[4].toObject()[key("voxels")].toInt();
        qInfo("%s", qPrintable(rows[4].toObject()[key("name")].toString()));
        QVERIFY2(voxels > 5000 && voxels < 6000, qPrintable(QString::number(voxels)));

        // Rows hold what they depend on; a recipe need not, and comes to the same.
        const Outcome replayed = burin({key("replay"), path("a.burin"), key("--verify")});
        QVERIFY2(replayed.status == 0, qPrintable(replayed.complaint));
        const Outcome written = burin({key("history"), path("a.burin"), key("--as-recipe")});
        QVERIFY(!written.output.contains("owners") && !written.output.contains("bricks"));
        const Outcome again =
            run(recipe("again.json", QJsonDocument::fromJson(written.output).object()), "b.burin");
        QVERIFY2(again.status == 0, qPrintable(again.complaint));
        QVERIFY(!lastHash("a.burin").isEmpty());
        QCOMPARE(lastHash("b.burin"), lastHash("a.burin"));
    }

    /// A recipe names the map's file; the row holds what was in it.
    void aProbabilityMapIsReadWithTheRecipe()
    {
        const Volume volume = test::smallStudy().volume;
        const std::vector<float> values(volume.geometry.voxelCount(), 0.25f);
        const QByteArray map = test::nrrd::onGrid(volume.geometry, "float",
            QByteArray(reinterpret_cast<const char*>(values.data()),
                qsizetype(values.size() * sizeof(float))));
        QFile file(path("map.nrrd"));
        QVERIFY(file.open(QIODevice::WriteOnly) && file.write(map) == map.size());
        file.close();

        DivideSegment division{.segment = 1, .marginMm = 6.0};
        division.probabilityFile = key("map.nrrd");
        const std::vector<Edit> edits{
            test::addSegment("Head"), test::seedInBrain(1), test::growBrain(), division};
        const QJsonObject wanted{{key("edits"), test::toJson(edits)}};
        const Outcome made = run(recipe("make.json", wanted), "a.burin");
        QVERIFY2(made.status == 0, qPrintable(made.complaint));
        const QString name =
            history("a.burin")[key("commands")].toArray()[3].toObject()[key("name")].toString();
        QVERIFY2(name.contains(key("by a probability map")), qPrintable(name));
        QVERIFY(QFile::remove(path("map.nrrd")));
        const Outcome replayed = burin({key("replay"), path("a.burin"), key("--verify")});
        QVERIFY2(replayed.status == 0, qPrintable(replayed.complaint));
        const Outcome refused = run(recipe("make.json", wanted), "b.burin");
        QVERIFY(refused.status != 0);
        QVERIFY2(refused.complaint.contains(key("map.nrrd")), qPrintable(refused.complaint));
    }

    void aClickWithoutADivisionIsRefused()
    {
        const std::vector<Edit> edits{test::addSegment("Head"),
            ChunkToggle{.segment = 1, .chunks = 4, .pointsLps = test::pointsInBone()}};
        const Outcome refused =
            run(recipe("make.json", {{key("edits"), test::toJson(edits)}}), "a.burin");
        QCOMPARE(refused.status, 1);
        QVERIFY2(refused.complaint.contains(key("edit 2")), qPrintable(refused.complaint));
        QVERIFY2(
            refused.complaint.contains(key("nothing is divided")), qPrintable(refused.complaint));
    }
};

BURIN_TEST(RunChunksGlTest)

} // namespace runChunksGlTest

#include "RunChunksGlTest.moc"
