// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/lists/MeasurementsPanel.h"

#include "core/edits/kinds/views/Measurements.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/fixtures/WindowFixture.h"
#include "tests/support/program/TestProgram.h"
#include "ui/measure/MeasuredRegions.h"

#include <QListWidget>
#include <QPushButton>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QtTest>

namespace measurementsPanelUiTest {

namespace {

using Kind = core::Measurement::Kind;

struct Fixture : test::WindowFixture {
    Fixture()
        : WindowFixture(test::headFirstSupine())
        , panel(new ui::MeasurementsPanel(workspace))
    {
        window.addPanel(panel);
        window.showPanels(true);
        list = panel->findChild<QListWidget*>(QStringLiteral("measurementList"));
    }
    void apply(const core::Edit& edit)
    {
        if (!session().apply(edit) || !session().settle())
            qFatal("refused");
    }

    ui::MeasurementsPanel* panel;
    QListWidget* list = nullptr;
};

} // namespace

class MeasurementsPanelUiTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnUnexpectedMessages(); }

    void itAppearsWithTheFirst()
    {
        Fixture fixture;
        QVERIFY(fixture.list);
        QSignalSpy shown(fixture.panel, &ui::Panel::hasSomethingChanged);
        QVERIFY(!fixture.panel->hasSomething());
        fixture.apply(core::AddMeasurement{.fromLps = {0, 0, 0}, .toLps = {3, 4, 0}, .piece = {}});
        QVERIFY(fixture.panel->hasSomething());
        QCOMPARE(shown.size(), 1);
        QCOMPARE(fixture.list->count(), 1);
        QCOMPARE(fixture.list->item(0)->text(), QStringLiteral("1 · distance · 5.0 mm"));
        QCOMPARE(fixture.panel->summary(), QStringLiteral("1"));
        QVERIFY(fixture.session().undo());
        QVERIFY(fixture.session().settle());
        QVERIFY(!fixture.panel->hasSomething());
        QCOMPARE(shown.size(), 2);
        QCOMPARE(fixture.list->count(), 0);
    }

    void aClickLeadsThere()
    {
        Fixture fixture;
        fixture.apply(core::AddMeasurement{.fromLps = {0, 0, 0}, .toLps = {4, 8, 12}, .piece = {}});
        fixture.apply(
            core::Annotate{.kind = Kind::Angle, .pointsLps = {{9, 0, 0}, {-5, 3, 6}, {0, 9, 0}}});
        fixture.window.bringUp(*fixture.panel);
        QTRY_VERIFY(fixture.list->isVisible());
        QCoreApplication::sendPostedEvents(); // layouts are posted events
        const QRect row = fixture.list->visualItemRect(fixture.list->item(0));
        QTest::mouseClick(fixture.list->viewport(), Qt::LeftButton, {}, row.center());
        QCOMPARE(fixture.workspace.crosshairLps(), (glm::dvec3(2, 4, 6)));
        Q_EMIT fixture.list->itemActivated(fixture.list->item(1));
        QCOMPARE(fixture.workspace.crosshairLps(), (glm::dvec3(-5, 3, 6))); // the vertex
    }

    /// Voxels of 2 × 2 × 3 mm whose value is 1000 + column − 1024: a box of 5 × 3 centres.
    void valuesFollow()
    {
        Fixture fixture;
        const ui::MeasuredRegions regions(fixture.workspace);
        const core::VolumeGeometry& geometry = fixture.workspace.volume()->geometry;
        const glm::dvec3 corner = geometry.toWorld({19.75, 9.75, 20.0});
        const core::Annotate box{.kind = Kind::Rectangle,
            .pointsLps = {corner, corner + glm::dvec3(9, 0, 0), corner + glm::dvec3(0, 5, 0)}};
        fixture.apply(box);
        const core::Measurement measured = fixture.session().document().measurements[0];
        QVERIFY(QTest::qWaitFor([&] {
            fixture.session().poll();
            return fixture.workspace.measured(measured) != nullptr;
        }));
        const auto values = fixture.workspace.measured(measured)->values;
        QVERIFY(values);
        QCOMPARE(values->voxels, 15);
        QCOMPARE(values->mean, -2.0); // columns 20 … 24
        QCOMPARE(values->minimum, -4.0);
        QCOMPARE(values->maximum, 0.0);
        // Spaces at which no row is broken.
        QVERIFY(fixture.list->item(0)->text().startsWith(
            QStringLiteral("1 · rectangle · 45.0 mm²\n9.0\u00A0×\u00A05.0\u00A0mm · mean\u00A0")));
        QVERIFY(fixture.list->item(0)->text().endsWith(QStringLiteral("\u00A0in\u00A015")));
        // After undo another one has its number, and other values.
        QVERIFY(fixture.session().undo());
        QVERIFY(fixture.session().settle());
        core::Annotate probe{.kind = Kind::Probe, .pointsLps = {geometry.toWorld({30, 10, 20})}};
        fixture.apply(probe);
        const core::Measurement place = fixture.session().document().measurements[0];
        QCOMPARE(place.id, measured.id);
        QVERIFY(!fixture.workspace.measured(place));
        QVERIFY(QTest::qWaitFor([&] {
            fixture.session().poll();
            return fixture.workspace.measured(place) != nullptr;
        }));
        QCOMPARE(fixture.workspace.measured(place)->values->mean, 6.0);
        QVERIFY(!regions.busy());
    }

    void theyAreSaved()
    {
        Fixture fixture;
        const ui::MeasuredRegions regions(fixture.workspace);
        auto* save = fixture.panel->findChild<QPushButton*>(QStringLiteral("saveMeasurements"));
        QVERIFY(save && !save->isEnabled());
        fixture.apply(core::AddMeasurement{.fromLps = {0, 0, 0}, .toLps = {3, 4, 0}, .piece = {}});
        QVERIFY(!save->isEnabled()); // still being worked out
        QVERIFY(QTest::qWaitFor([&] {
            fixture.session().poll();
            return save->isEnabled();
        }));
        const QTemporaryDir folder;
        const QString name = folder.filePath(QStringLiteral("a.csv"));
        QSignalSpy said(&fixture.workspace, &ui::Workspace::said);
        fixture.panel->saveAs(name);
        QTRY_COMPARE(said.size(), 1);
        QFile file(name);
        QVERIFY(file.open(QIODevice::ReadOnly));
        QVERIFY(file.readAll().contains("1,distance,\"\",no,mm,\"HU\",5,,"));
    }

    void theyAreTakenAway()
    {
        Fixture fixture;
        for (int i = 1; i <= 3; ++i)
            fixture.apply(core::Annotate{
                .kind = Kind::Probe, .pointsLps = {glm::dvec3(double(i), 0.0, 0.0)}});
        auto* remove = fixture.panel->findChild<QPushButton*>(QStringLiteral("removeMeasurements"));
        QVERIFY(remove && !remove->isEnabled());
        fixture.list->item(0)->setSelected(true);
        fixture.list->item(2)->setSelected(true);
        QVERIFY(remove->isEnabled());
        remove->click();
        QVERIFY(fixture.session().settle());
        QCOMPARE(fixture.list->count(), 1);
        QCOMPARE(fixture.session().document().measurements[0].id, 2);
        QVERIFY(!remove->isEnabled());
        QVERIFY(fixture.session().undo());
        QVERIFY(fixture.session().settle());
        QCOMPARE(fixture.list->count(), 2);
        QVERIFY(fixture.list->item(0)->text().startsWith(QStringLiteral("2 · probe")));
    }
};

BURIN_WINDOW_TEST(MeasurementsPanelUiTest)

} // namespace measurementsPanelUiTest

#include "MeasurementsPanelUiTest.moc"
