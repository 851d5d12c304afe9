// SPDX-License-Identifier: Apache-2.0
#include "ui/dialogs/segment/MirrorDialog.h"

#include "core/edits/kinds/filling/MirrorSegment.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/fixtures/WindowFixture.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/PlainEdits.h"
#include "tests/support/scenes/SmallStudy.h"
#include "ui/base/NumberText.h"

#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QPushButton>
#include <QSettings>
#include <QSignalSpy>
#include <QTimer>
#include <QtTest>

namespace mirrorDialogUiTest {

namespace {

/// A segment on one side, and its dialog when the menu Segments has opened it.
struct Fixture : test::WindowFixture {
    Fixture()
        : WindowFixture(test::smallStudy())
    {
        apply(test::addSegment("Kidney"));
        apply(test::paintAt(1, {place({10.0, 12.0, 10.0})}, 3.0));
        workspace.setActiveSegment(1);
        before = voxels(1);
        // As the engine's thread wakes the window in the program.
        QObject::connect(&wakeUp, &QTimer::timeout, [this] {
            if (core::EditSession* open = workspace.session())
                open->poll();
        });
        wakeUp.start(10);
    }
    using WindowFixture::voxels;
    [[nodiscard]] ui::MirrorDialog& opened()
    {
        window.actionTable()[QStringLiteral("segments.mirrorBy")].trigger();
        return *window.findChild<ui::MirrorDialog*>();
    }
    [[nodiscard]] const core::MirrorSegment* previewed()
    {
        const core::Edit* open = session().openEdit();
        return open && session().openIsPreview() ? open->as<core::MirrorSegment>() : nullptr;
    }
    [[nodiscard]] QString sizeOf(std::size_t count)
    {
        return ui::volumeText(
            double(count) * workspace.volume()->geometry.voxelVolumeMm3() / 1000.0);
    }
    /// Those of the segment before, and their mirror image along an axis.
    [[nodiscard]] std::set<std::array<int, 3>> image(int axis, int sum) const
    {
        std::set<std::array<int, 3>> mirrored;
        for (std::array<int, 3> voxel : before) {
            voxel.at(std::size_t(axis)) = sum - voxel.at(std::size_t(axis));
            mirrored.insert(voxel);
        }
        return mirrored;
    }

    QTimer wakeUp;
    std::set<std::array<int, 3>> before; ///< the segment's voxels
};

template <class Widget> Widget& part(const QWidget& dialog, const char* name)
{
    auto* found = dialog.findChild<Widget*>(QLatin1String(name));
    if (!found)
        qFatal("no widget %s", name);
    return *found;
}

QString nowOf(const QWidget& dialog)
{
    return part<QLabel>(dialog, "mirrorNow").text();
}

void press(const QWidget& dialog)
{
    QTest::mouseClick(&part<QPushButton>(dialog, "applyMirror"), Qt::LeftButton);
}

} // namespace

class MirrorDialogUiTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init()
    {
        test::failOnUnexpectedMessages();
        QSettings().remove(QStringLiteral("mirror"));
    }

    /// It is seen before it is a step, and what is seen is taken; so is what is kept beside it.
    void isSeenAndTaken()
    {
        for (const bool keep : {false, true}) {
            Fixture fixture;
            const std::size_t count = fixture.before.size();
            const int width = fixture.workspace.volume()->geometry.size.x;
            const std::size_t rows = fixture.rows();
            ui::MirrorDialog& dialog = fixture.opened();
            QVERIFY(dialog.isVisible() && !dialog.isModal());
            QCOMPARE(part<QLabel>(dialog, "mirrorWhose").text(), QStringLiteral("Kidney"));
            auto& box = part<QCheckBox>(dialog, "mirrorKeep");
            QVERIFY(!box.isChecked());
            const QString asLarge =
                QStringLiteral("Preview: %1, as large as now").arg(fixture.sizeOf(count));
            QTRY_COMPARE(nowOf(dialog), asLarge);
            QVERIFY(fixture.previewed() && !fixture.previewed()->keep);
            if (keep) {
                box.click();
                QTRY_COMPARE(nowOf(dialog),
                    QStringLiteral("Preview: %1 → %2 (+%1)")
                        .arg(fixture.sizeOf(count), fixture.sizeOf(2 * count)));
                QVERIFY(fixture.previewed() && fixture.previewed()->keep);
            }
            QCOMPARE(fixture.rows(), rows);
            QSignalSpy said(&fixture.workspace, &ui::Workspace::said);
            press(dialog);
            QVERIFY(!fixture.session().openEdit() && fixture.session().settle());
            QCOMPARE(fixture.rows(), rows + 1);
            QTRY_COMPARE(said.size(), 1);
            std::set<std::array<int, 3>> expected = fixture.image(0, width - 1);
            if (keep)
                expected.insert(fixture.before.begin(), fixture.before.end());
            QVERIFY(fixture.voxels(1) == expected);
            // What was taken is not done once more by itself.
            QTest::qWait(500);
            QVERIFY(!fixture.session().openEdit() && dialog.isVisible());
            if (keep) {
                press(dialog);
                QVERIFY(fixture.session().settle());
                QTRY_COMPARE(said.size(), 2);
                QCOMPARE(said.back().front().toString(),
                    QStringLiteral("'Kidney' has its mirror image already"));
            }
            QVERIFY(fixture.session().undo() && fixture.session().settle());
            QVERIFY(fixture.voxels(1) == fixture.before);
        }
    }

    /// Each choice is its edit; about the crosshair it goes along with that.
    void thePreviewFollows()
    {
        Fixture fixture;
        const QByteArray hash = fixture.session().stateHash();
        const glm::dvec3 first = fixture.place({18.0, 12.0, 10.0});
        const glm::dvec3 second = fixture.place({22.0, 14.0, 12.0});
        fixture.workspace.setCrosshairLps(first);
        ui::MirrorDialog& dialog = fixture.opened();
        const auto seen = [&](core::MirroredSides sides, std::optional<glm::dvec3> place) {
            return QTest::qWaitFor([&] {
                const core::MirrorSegment* edit = fixture.previewed();
                return edit && edit->sides == sides && edit->placeLps == place
                    && fixture.session().openHasBegun()
                    && nowOf(dialog).startsWith(QStringLiteral("Preview: "));
            });
        };
        auto& sides = part<QComboBox>(dialog, "mirrorSides");
        auto& place = part<QComboBox>(dialog, "mirrorPlace");
        QVERIFY(seen(core::MirroredSides::RightLeft, std::nullopt));
        sides.setCurrentText(QStringLiteral("Front and back"));
        QVERIFY(seen(core::MirroredSides::AnteriorPosterior, std::nullopt));
        sides.setCurrentText(QStringLiteral("Head and feet"));
        QVERIFY(seen(core::MirroredSides::InferiorSuperior, std::nullopt));
        sides.setCurrentText(QStringLiteral("Left and right"));
        place.setCurrentText(QStringLiteral("about the crosshair"));
        QVERIFY(seen(core::MirroredSides::RightLeft, first));
        fixture.workspace.setCrosshairLps(second);
        QVERIFY(seen(core::MirroredSides::RightLeft, second));
        auto& box = part<QCheckBox>(dialog, "mirrorPreview");
        box.setChecked(false);
        QVERIFY(!fixture.session().openEdit());
        box.setChecked(true);
        QVERIFY(seen(core::MirroredSides::RightLeft, second));
        dialog.reject();
        QVERIFY(!fixture.session().openEdit() && fixture.session().settle());
        QCOMPARE(fixture.session().stateHash(), hash);
        // Opened again, it has what was chosen.
        QVERIFY(&fixture.opened() == &dialog);
        QVERIFY(seen(core::MirroredSides::RightLeft, second));
        press(dialog);
        QVERIFY(fixture.session().settle());
        QVERIFY(fixture.voxels(1) == fixture.image(0, 44));
    }

    void whatCannotBeSaysWhy()
    {
        Fixture fixture;
        ui::MirrorDialog& dialog = fixture.opened();
        auto& apply = part<QPushButton>(dialog, "applyMirror");
        QVERIFY(apply.isEnabled());
        fixture.apply(test::lockSegment(1));
        QVERIFY(!apply.isEnabled());
        QCOMPARE(apply.toolTip(), QStringLiteral("'Kidney' is locked"));
        part<QCheckBox>(dialog, "mirrorKeep").click();
        QTest::qWait(500);
        QVERIFY(!fixture.session().openEdit());
        QVERIFY(!fixture.window.actionTable()[QStringLiteral("segments.mirrorBy")].isEnabled());
    }
};

BURIN_WINDOW_TEST(MirrorDialogUiTest)

} // namespace mirrorDialogUiTest

#include "MirrorDialogUiTest.moc"
