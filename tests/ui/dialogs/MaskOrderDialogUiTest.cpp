// SPDX-License-Identifier: Apache-2.0
#include "ui/dialogs/MaskOrderDialog.h"

#include "core/edits/kinds/imports/ImportMask.h"
#include "core/session/EditSession.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/fixtures/WindowFixture.h"
#include "tests/support/program/TestProgram.h"
#include "ui/frame/MessageBar.h"
#include "ui/tasks/MaskImporter.h"
#include "ui/widgets/FittingLabel.h"

#include <QFile>
#include <QListWidget>
#include <QPointer>
#include <QPushButton>
#include <QRadioButton>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

namespace maskOrderDialogUiTest {

namespace {

QByteArray vectorText(const glm::dvec4& vector)
{
    QByteArray text;
    for (int part = 0; part < 3; ++part)
        text += (part ? "," : "(") + QByteArray::number(vector[part], 'g', 17);
    return text + ')';
}

/// A mask of two layers: 'Low' in the slices 0 and 1, 'High' in 1, 2 and 3, and 'Apart' in 10.
struct Fixture : test::WindowFixture {
    Fixture()
        : test::WindowFixture(test::headFirstSupine())
    {
        const core::VolumeGeometry& geometry = workspace.volume()->geometry;
        const glm::ivec3 size = geometry.size;
        const qsizetype slice = qsizetype(size.x) * size.y;
        QByteArray labels(2 * slice * size.z, '\0'); // two layers a voxel
        for (qsizetype voxel = 0; voxel < slice * size.z; ++voxel) {
            const qsizetype k = voxel / slice;
            labels[2 * voxel] = k < 2 ? 1 : k == 10 ? 2 : 0;
            labels[2 * voxel + 1] = k > 0 && k < 4 ? 1 : 0;
        }
        QByteArray text = "NRRD0004\ntype: uchar\nencoding: raw\nspace: left-posterior-superior\n"
                          "dimension: 4\nkinds: list domain domain domain\nsizes: 2";
        for (int axis = 0; axis < 3; ++axis)
            text += ' ' + QByteArray::number(size[axis]);
        text += "\nspace directions: none";
        for (int axis = 0; axis < 3; ++axis)
            text += ' ' + vectorText(geometry.indexToWorld[axis]);
        text += "\nspace origin: " + vectorText(geometry.indexToWorld[3])
            + "\nSegment0_ID:=a\nSegment0_Name:=Low\nSegment0_LabelValue:=1\nSegment0_Layer:=0\n"
              "Segment1_ID:=b\nSegment1_Name:=High\nSegment1_LabelValue:=1\nSegment1_Layer:=1\n"
              "Segment2_ID:=c\nSegment2_Name:=Apart\nSegment2_LabelValue:=2\nSegment2_Layer:=0\n\n";
        QFile mask(file);
        if (!mask.open(QIODevice::WriteOnly) || mask.write(text + labels) <= 0)
            qFatal("cannot write %s", qPrintable(file));
    }
    [[nodiscard]] ui::MaskImporter& importer() { return window.importer(); }
    /// The dialog, once the file has been read.
    [[nodiscard]] ui::MaskOrderDialog* asked()
    {
        importer().import(file);
        ui::MaskOrderDialog* dialog = nullptr;
        const bool found = QTest::qWaitFor([&] {
            dialog = window.findChild<ui::MaskOrderDialog*>();
            return dialog && dialog->isVisible();
        });
        return found ? dialog : nullptr;
    }
    /// The label of every voxel of a slice; −1 where they differ.
    [[nodiscard]] int labelOfSlice(int k, std::uint8_t plane = 0)
    {
        reference::DenseFields fields = engine.fields();
        const auto& labels = fields.labels(plane);
        const glm::ivec3 size = workspace.volume()->geometry.size;
        const int first = labels.at({0, 0, k});
        for (int y = 0; y < size.y; ++y) {
            for (int x = 0; x < size.x; ++x) {
                if (labels.at({x, y, k}) != first)
                    return -1;
            }
        }
        return first;
    }

    QTemporaryDir folder;
    QString file = folder.filePath(QStringLiteral("two.seg.nrrd"));
};

QListWidget& listOf(const QWidget& dialog, const char* name)
{
    return *dialog.findChild<QListWidget*>(QLatin1String(name));
}

void click(const QWidget& dialog, const char* name)
{
    QTest::mouseClick(dialog.findChild<QPushButton*>(QLatin1String(name)), Qt::LeftButton);
}

/// Clicks on a radio button's circle, at its left end.
void choose(const QWidget& dialog, const char* name)
{
    auto* button = dialog.findChild<QRadioButton*>(QLatin1String(name));
    QTest::mouseClick(button, Qt::LeftButton, {}, QPoint(8, button->height() / 2));
}

} // namespace

class MaskOrderDialogUiTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnUnexpectedMessages(); }

    /// What the dialog proposes: both keep what they share, in two planes.
    void overlapsAreKept()
    {
        Fixture fixture;
        const QPointer<ui::MaskOrderDialog> dialog = fixture.asked();
        QVERIFY(dialog);
        QVERIFY(dialog->findChild<QRadioButton*>(QStringLiteral("maskOrderKeep"))->isChecked());
        QVERIFY(!listOf(*dialog, "maskOrder").isEnabled());
        QVERIFY(!dialog->findChild<QPushButton*>(QStringLiteral("maskOrderDown"))->isEnabled());
        QVERIFY(dialog->findChild<ui::FittingLabel*>()->text().endsWith(
            QStringLiteral("overlap in 3 072 voxels")));
        QListWidget& given = listOf(*dialog, "maskOrderGiven");
        QCOMPARE(given.count(), 1);
        QCOMPARE(given.item(0)->text(),
            QStringLiteral("Each segment keeps its voxels; the segments lie in 2 label planes."));
        QTest::keyClick(dialog.data(), Qt::Key_Return);
        QVERIFY(fixture.session().settle());
        QCOMPARE(fixture.session().history().rows().size(), std::size_t(1));
        const auto& edit = fixture.session().history().rows().back().edit.get<core::ImportMask>();
        QVERIFY(!edit.ahead);
        QCOMPARE(*edit.planes, (std::vector<int>{0, 1, 0}));
        const auto& segments = fixture.session().document().segments;
        QCOMPARE(segments.size(), std::size_t(3));
        QCOMPARE(int(segments[1].plane), 1);
        for (const int k : {0, 1})
            QCOMPARE(fixture.labelOfSlice(k), int(segments[0].label));
        for (const int k : {1, 2, 3})
            QCOMPARE(fixture.labelOfSlice(k, 1), int(segments[1].label));
        QCOMPARE(fixture.labelOfSlice(2), 0);
        QCOMPARE(fixture.labelOfSlice(0, 1), 0);
        QCOMPARE(fixture.labelOfSlice(10), int(segments[2].label));
        const QString sentence = fixture.window.messages().sentence();
        QVERIFY2(sentence.contains(QLatin1String("the segments lie in 2 label planes.")),
            qPrintable(sentence));
    }

    void theOneFurtherUpGetsTheVoxels()
    {
        Fixture fixture;
        const QPointer<ui::MaskOrderDialog> dialog = fixture.asked();
        QVERIFY(dialog);
        QVERIFY(dialog->isModal());
        QVERIFY(fixture.importer().busy());
        QVERIFY(fixture.session().history().rows().empty());
        choose(*dialog, "maskOrderFlatten");
        QListWidget& order = listOf(*dialog, "maskOrder");
        QListWidget& given = listOf(*dialog, "maskOrderGiven");
        QCOMPARE(order.count(), 2); // what does not overlap is not asked about
        QCOMPARE(order.item(0)->text(), QStringLiteral("Low"));
        QCOMPARE(order.item(1)->text(), QStringLiteral("High"));
        // The lists are as tall as their few rows need, and the colour of the chosen one is its
        // own.
        QTRY_VERIFY(order.height() >= order.sizeHint().height());
        QVERIFY(given.height() >= given.sizeHint().height());
        QVERIFY(order.geometry().bottom() < given.geometry().top());
        QVERIFY(dialog->height() < 500);
        const QIcon swatch = order.item(0)->icon();
        const auto colourOf = [&swatch](QIcon::Mode mode) {
            return swatch.pixmap(QSize(12, 12), mode).toImage().pixelColor(6, 6);
        };
        QCOMPARE(colourOf(QIcon::Selected), colourOf(QIcon::Normal));
        QCOMPARE(given.count(), 1);
        QCOMPARE(given.item(0)->text(),
            QStringLiteral("'Low' goes before 'High' in 3 072 voxels (36.9 mL) that both have."));
        QVERIFY(!dialog->ahead());
        QVERIFY(!dialog->findChild<QPushButton*>(QStringLiteral("maskOrderUp"))->isEnabled());
        click(*dialog, "maskOrderDown");
        QCOMPARE(order.item(0)->text(), QStringLiteral("High"));
        QCOMPARE(order.currentRow(), 1);
        QCOMPARE(given.count(), 1);
        QVERIFY(given.item(0)->text().startsWith(QStringLiteral("'High' goes before 'Low' in ")));
        QCOMPARE(*dialog->ahead(), (std::vector<int>{2, 1}));
        QVERIFY(!dialog->findChild<QPushButton*>(QStringLiteral("maskOrderDown"))->isEnabled());
        click(*dialog, "maskOrderUp");
        QVERIFY(!dialog->ahead());
        click(*dialog, "maskOrderDown");

        QSignalSpy imported(&fixture.importer(), &ui::MaskImporter::imported);
        click(*dialog, "maskOrderImport");
        QVERIFY(!fixture.importer().busy());
        QVERIFY(fixture.session().settle());
        QTRY_VERIFY(!dialog);
        QCOMPARE(imported.count(), 1);
        QCOMPARE(fixture.session().history().rows().size(), std::size_t(1));
        const auto& edit = fixture.session().history().rows().back().edit.get<core::ImportMask>();
        QCOMPARE(*edit.ahead, (std::vector<int>{2, 1}));
        QVERIFY(!edit.planes);
        const auto& segments = fixture.session().document().segments;
        QCOMPARE(segments.size(), std::size_t(3));
        QCOMPARE(segments[0].name, QStringLiteral("Low"));
        QCOMPARE(fixture.labelOfSlice(0), int(segments[0].label));
        for (const int k : {1, 2, 3})
            QCOMPARE(fixture.labelOfSlice(k), int(segments[1].label));
        QCOMPARE(fixture.labelOfSlice(4), 0);
        QCOMPARE(fixture.labelOfSlice(10), int(segments[2].label));
        const QString sentence = fixture.window.messages().sentence();
        for (const char* part : {"Segments overlap in 3 072 voxels.",
                 "'High' goes before 'Low' in 3 072 voxels (36.9 mL) that both have."})
            QVERIFY2(sentence.contains(QLatin1String(part)), qPrintable(sentence));
    }

    /// The order of the file needs no word in the edit.
    void asInTheFile()
    {
        Fixture fixture;
        const QPointer<ui::MaskOrderDialog> dialog = fixture.asked();
        QVERIFY(dialog);
        choose(*dialog, "maskOrderFlatten");
        QTest::keyClick(dialog.data(), Qt::Key_Return);
        QVERIFY(fixture.session().settle());
        QCOMPARE(fixture.session().history().rows().size(), std::size_t(1));
        const auto& edit = fixture.session().history().rows().back().edit.get<core::ImportMask>();
        QVERIFY(!edit.ahead);
        QVERIFY(!edit.planes);
        const auto& segments = fixture.session().document().segments;
        QCOMPARE(fixture.labelOfSlice(1), int(segments[0].label));
        QCOMPARE(fixture.labelOfSlice(2), int(segments[1].label));
    }

    void cancelledNothingIsTakenIn()
    {
        Fixture fixture;
        const QPointer<ui::MaskOrderDialog> dialog = fixture.asked();
        QVERIFY(dialog);
        click(*dialog, "maskOrderCancel");
        QVERIFY(!fixture.importer().busy());
        QVERIFY(fixture.session().settle());
        QVERIFY(fixture.session().history().rows().empty());
        QTRY_VERIFY(!dialog);
        fixture.importer().import(std::nullopt, std::nullopt); // nothing waits any more
        QVERIFY(fixture.session().settle());
        QVERIFY(fixture.session().history().rows().empty());
        QVERIFY(fixture.asked()); // and it can be asked for again
    }

    void theStudyIsClosed()
    {
        Fixture fixture;
        const QPointer<ui::MaskOrderDialog> dialog = fixture.asked();
        QVERIFY(dialog);
        fixture.workspace.setSession(nullptr);
        QVERIFY(!fixture.importer().busy());
        QTRY_VERIFY(!dialog);
    }
};

BURIN_WINDOW_TEST(MaskOrderDialogUiTest)

} // namespace maskOrderDialogUiTest

#include "MaskOrderDialogUiTest.moc"
