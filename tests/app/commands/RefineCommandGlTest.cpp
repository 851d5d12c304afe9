// SPDX-License-Identifier: Apache-2.0
#include "core/study/StudyLoader.h"
#include "tests/support/cases/SurfaceCases.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/fixtures/CommandFixture.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/SmallStudy.h"

#include <QTest>

#include <algorithm>

namespace refineCommandGlTest {

using namespace core;
using test::burin;
using test::key;
using test::Outcome;

/// `burin run` repairs a mask by its surface, and `burin replay` comes to the same state.
class RefineCommandGlTest : public QObject, protected test::CommandFixture {
    Q_OBJECT

    [[nodiscard]] static QJsonObject edit(const char* name, QJsonObject fields)
    {
        fields.insert(key("edit"), key(name));
        return fields;
    }
    [[nodiscard]] static QJsonObject on(const glm::dvec3& placeLps, double radiusMm)
    {
        return {{key("radiusMm"), radiusMm},
            {key("pointsLps"),
                QJsonArray{QJsonValue(QJsonArray{placeLps.x, placeLps.y, placeLps.z})}}};
    }

private Q_SLOTS:
    void initTestCase() { QVERIFY(prepareStudy()); }
    void init()
    {
        test::failOnUnexpectedMessages();
        makeFolder();
    }

    void aMaskIsRepaired()
    {
        const VolumeGeometry geometry = test::smallStudy().volume.geometry;
        const glm::dvec3 spacing = geometry.spacingMm();
        const double voxelMm = std::min({spacing.x, spacing.y, spacing.z});
        const glm::dvec3 side =
            geometry.toWorld((glm::dvec3(geometry.size) - 1.0) / 2.0 + glm::dvec3(9.0, 0.0, 0.0));
        QJsonObject red = on(side, 5.0 * voxelMm);
        red.insert(key("mark"), key("red"));
        const QJsonArray edits{test::toJson({test::ballMask(geometry.size, 9.0)}).first(),
            edit("surface", {{key("segment"), 1}, {key("vertices"), 800}}), edit("mark", red),
            edit("spherePush", on(side, 4.0 * voxelMm)), edit("writeBack", {})};
        const QJsonArray exports{
            QJsonObject{{key("format"), key("nifti")}, {key("file"), path("out.nii.gz")}}};
        const Outcome made = run(
            recipe("repair.json", {{key("edits"), edits}, {key("export"), exports}}), "a.burin");
        QVERIFY2(made.status == 0, qPrintable(made.complaint));
        QCOMPARE(made.lines[1][key("edit")].toString(), key("surface"));
        const QString last = made.lines[4][key("name")].toString();
        QVERIFY2(last.startsWith(key("Write surface back to 'Ball', ")), qPrintable(last));
        const Result<LoadedVolume> labels = loadVolume(path("out.nii.gz"));
        QVERIFY(labels);
        QCOMPARE(labels->volume.maximum, 1.0);

        const Outcome replayed = burin({key("replay"), path("a.burin"), key("--verify")});
        QVERIFY2(replayed.status == 0, qPrintable(replayed.complaint));
        // What it recorded is a recipe that comes to the same state.
        QCOMPARE(run(recipeOf("a.burin", "again.json"), "b.burin").status, 0);
        QVERIFY(!lastHash("a.burin").isEmpty());
        QCOMPARE(lastHash("b.burin"), lastHash("a.burin"));
    }

    void withoutASurfaceItIsRefused()
    {
        const QJsonArray edits{
            test::toJson({test::ballMask(test::smallStudy().volume.geometry.size, 9.0)}).first(),
            edit("writeBack", {})};
        const Outcome outcome = run(recipe("repair.json", {{key("edits"), edits}}), "a.burin");
        QCOMPARE(outcome.status, 1);
        QVERIFY2(outcome.complaint.contains(key("there is none")), qPrintable(outcome.complaint));
    }
};

BURIN_TEST(RefineCommandGlTest)

} // namespace refineCommandGlTest

#include "RefineCommandGlTest.moc"
