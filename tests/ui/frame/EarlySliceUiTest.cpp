// SPDX-License-Identifier: Apache-2.0
#include "tests/support/fixtures/ApplicationFixture.h"
#include "tests/support/fixtures/WindowFixture.h"
#include "tests/support/program/TestProgram.h"
#include "ui/frame/LoadingBar.h"
#include "ui/frame/MessageBar.h"
#include "ui/frame/PanelSection.h"
#include "ui/panels/VolumePanel.h"
#include "ui/panels/lists/SegmentsPanel.h"
#include "ui/views/EarlyPicture.h"
#include "ui/views/ViewGrid.h"

#include <QAction>
#include <QLabel>
#include <QPushButton>
#include <QSignalSpy>
#include <QTest>
#include <QWheelEvent>

#include <future>
#include <memory>
#include <thread>

namespace earlySliceUiTest {

namespace {

const QString somewhere = QStringLiteral("/somewhere/study");

std::shared_ptr<const core::EarlySlice> middleOf(const core::LoadedVolume& loaded)
{
    auto early = std::make_shared<core::EarlySlice>();
    early->volume = loaded.volume;
    early->volume.histogram = {};
    early->slice = loaded.volume.geometry.size.z / 2;
    const std::size_t size =
        std::size_t(loaded.volume.geometry.size.x) * std::size_t(loaded.volume.geometry.size.y);
    const auto first = loaded.codes.begin() + std::ptrdiff_t(size * std::size_t(early->slice));
    early->codes.assign(first, first + std::ptrdiff_t(size));
    return early;
}

/// A window that opens a study, which stays at one slice until it is told to go on.
class Opening {
public:
    explicit Opening(core::LoadedVolume volume, bool besideAnother = false)
        : fixture(test::headFirstSupine())
        , early(middleOf(volume))
        , m_volume(std::move(volume))
    {
        fixture.window.addPanel(new ui::SegmentsPanel(fixture.workspace));
        fixture.window.addPanel(new ui::VolumePanel(fixture.workspace));
        if (!besideAnother)
            fixture.workspace.setSession(nullptr);
        QObject::connect(&opener(), &ui::StudyOpener::loaded, &fixture.window,
            [this](const std::shared_ptr<core::LoadedVolume>& loaded) {
                fixture.workspace.setSession(nullptr);
                auto session = core::EditSession::create(fixture.engine, std::move(*loaded), {});
                if (!session)
                    qFatal("the session could not be made");
                fixture.workspace.setSession(std::move(*session));
            });
    }
    ~Opening() { goOn(); }

    ui::StudyOpener& opener() { return fixture.window.opener(); }
    ui::ViewGrid& views() const { return fixture.window.views(); }

    /// Up to the slice that is there.
    void begin(const std::optional<core::Error>& error = {})
    {
        QSignalSpy told(&opener(), &ui::StudyOpener::sliceReady);
        opener().run(somewhere,
            [slice = early, volume = m_volume, error, gate = m_goOn.get_future().share()](
                const core::Progress& progress,
                const core::EarlySliceListener& listener) -> core::Result<core::LoadedVolume> {
                listener(slice);
                progress.report(core::ProgressStep::ReadingSlices, 120, 450);
                gate.wait();
                if (error)
                    return tl::unexpected(*error);
                return volume;
            });
        QTRY_COMPARE_WITH_TIMEOUT(told.size(), 1, test::ApplicationFixture::patience);
    }
    void goOn()
    {
        if (!std::exchange(m_gone, true))
            m_goOn.set_value();
    }
    void end()
    {
        QSignalSpy finished(&opener(), &ui::StudyOpener::finished);
        goOn();
        QTRY_COMPARE_WITH_TIMEOUT(finished.size(), 1, test::ApplicationFixture::patience);
    }

    test::WindowFixture fixture;
    std::shared_ptr<const core::EarlySlice> early;

private:
    core::LoadedVolume m_volume;
    std::promise<void> m_goOn;
    bool m_gone = false;
};

/// Where a view stands in the window and what it looks at, once layouts have settled.
QString stand(const ui::SliceView& view)
{
    for (int round = 0; round < 3; ++round)
        QCoreApplication::processEvents();
    const QPoint place = view.mapTo(view.window(), QPoint());
    const QPointF origin = view.context().toPixel({0.0, 0.0, 0.0});
    const QPointF beside = view.context().toPixel({10.0, -20.0, 5.0});
    const core::WindowLevel window = std::get<gpu::SliceScene>(view.context().scene).window;
    return QStringLiteral("%1 × %2 at %3, %4; origin at %5, %6; ")
               .arg(view.width())
               .arg(view.height())
               .arg(place.x())
               .arg(place.y())
               .arg(origin.x())
               .arg(origin.y())
        + QStringLiteral("a place beside it at %1, %2; ").arg(beside.x()).arg(beside.y())
        + QStringLiteral("window %1, %2; slice %3 of %4")
              .arg(window.centre)
              .arg(window.width)
              .arg(view.sliceNumber())
              .arg(view.sliceCount());
}

} // namespace

/// A study on its way: the slice that is there already stands where it will stand.
class EarlySliceUiTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void standsWhereItWill();
    void nothingCanBeDoneToIt();
    void cautionMovesNothing();
    void inTheViewItWasTakenIn();
    void obliqueOnesWait();
    void abortedItIsGone();
    void closingTheStudyAborts();
    void failingLeavesAMessage();
    void anOpenStudyStays();
    void closingTheWindowAborts();
};

void EarlySliceUiTest::standsWhereItWill()
{
    Opening opening(test::plainCt(test::headFirstSupine()));
    QVERIFY(!opening.views().isVisible());
    opening.begin();
    const ui::SliceView& axial = opening.views().axial();
    QVERIFY(!opening.fixture.workspace.volume());
    QVERIFY(axial.isVisible());
    const QString before = stand(axial);
    const QImage shown = axial.picture();
    QCOMPARE(shown,
        ui::earlyPicture(
            *opening.early, std::get<gpu::SliceScene>(axial.context().scene), axial.size()));
    // Its columns grow lighter to the patient's left.
    const QPointF left = axial.context().toPixel({-50.0, 0.0, 1.5});
    const QPointF right = axial.context().toPixel({50.0, 0.0, 1.5});
    QVERIFY(qGray(shown.pixel(left.toPoint())) < qGray(shown.pixel(right.toPoint())));
    for (const ui::ImageView* view : opening.views().views())
        QCOMPARE(view->picture().isNull(), view != &axial);
    QVERIFY(!opening.views().refined());
    QVERIFY(opening.fixture.window.windowTitle().contains(QStringLiteral("TEST, WINDOW")));
    const auto* bar = opening.fixture.window.findChild<ui::LoadingBar*>();
    QVERIFY(bar->isVisible());
    QStringList said;
    for (const QLabel* label : bar->findChildren<QLabel*>())
        said += label->text();
    QVERIFY2(said.join(u' ').contains(QStringLiteral("120 of 450")), qPrintable(said.join(u' ')));
    test::look(opening.fixture.window.grab(), "early-slice.png");

    opening.end();
    QVERIFY(opening.fixture.workspace.volume());
    QVERIFY(!bar->isVisible());
    QCOMPARE(stand(axial), before);
    QTRY_VERIFY(opening.views().refined());
    for (const ui::ImageView* view : opening.views().views())
        QVERIFY(!view->isVisible() || !view->picture().isNull());
    QVERIFY(axial.picture() != shown); // pictures of FakeFrames are coloured
}

void EarlySliceUiTest::nothingCanBeDoneToIt()
{
    Opening opening(test::plainCt(test::headFirstSupine()));
    opening.begin();
    ui::SliceView& axial = opening.views().axial();
    const QString before = stand(axial);
    const QImage shown = axial.picture();
    QSignalSpy finished(&opening.opener(), &ui::StudyOpener::finished);
    for (const Qt::Key key : {Qt::Key_Up, Qt::Key_PageDown, Qt::Key_Home, Qt::Key_1, Qt::Key_Space})
        QTest::keyClick(&axial, key);
    const QPointF at(axial.width() / 2.0, axial.height() / 2.0);
    QWheelEvent wheel(at, axial.mapToGlobal(at), QPoint(), QPoint(0, 240), Qt::NoButton, {},
        Qt::NoScrollPhase, false);
    QApplication::sendEvent(&axial, &wheel);
    for (ui::ImageView* view : opening.views().views()) {
        QTest::mouseClick(view, Qt::LeftButton, {}, QPoint(40, 40));
        QTest::mousePress(view, Qt::MiddleButton, {}, QPoint(60, 60));
        QTest::mouseMove(view, QPoint(90, 70));
        QTest::mouseRelease(view, Qt::MiddleButton, {}, QPoint(90, 70));
    }
    for (const auto* section : opening.fixture.window.findChildren<ui::PanelSection*>())
        QVERIFY(section->isVisible() && !section->isEnabled());
    for (const char* id : {"edit.undo", "segments.add", "file.importMask", "file.saveAs"})
        QVERIFY2(!opening.fixture.window.actionTable()[QLatin1String(id)].isEnabled(), id);
    QCOMPARE(stand(axial), before);
    QCOMPARE(axial.picture(), shown);
    QVERIFY(finished.isEmpty());
    opening.end();
    QCOMPARE(stand(axial), before);
    for (const auto* section : opening.fixture.window.findChildren<ui::PanelSection*>())
        QVERIFY(section->isEnabled());
}

void EarlySliceUiTest::cautionMovesNothing()
{
    core::LoadedVolume volume = test::plainCt(test::headFirstSupine());
    volume.volume.problems = {{core::VolumeProblem::Kind::Tilt,
        {core::ProblemCode::AsStored, {QStringLiteral("The slices are tilted by 12°.")}}, true}};
    Opening opening(std::move(volume));
    opening.begin();
    const ui::MessageBar& bar = opening.fixture.window.messages();
    QVERIFY(bar.isVisible());
    QVERIFY(bar.sentence().contains(QStringLiteral("tilted by 12°")));
    const QString before = stand(opening.views().axial());
    opening.end();
    QVERIFY(bar.isVisible());
    QCOMPARE(stand(opening.views().axial()), before);
}

void EarlySliceUiTest::inTheViewItWasTakenIn()
{
    Opening opening(test::plainCt(test::sagittalAcquisition()));
    opening.begin();
    QVERIFY(!opening.views().sagittal().picture().isNull());
    QVERIFY(opening.views().axial().picture().isNull());
    const QString before = stand(opening.views().sagittal());
    opening.end();
    QCOMPARE(stand(opening.views().sagittal()), before);
}

/// None of the three planes is that slice: nothing is shown that would not stay.
void EarlySliceUiTest::obliqueOnesWait()
{
    Opening opening(test::plainCt(test::oblique()));
    opening.begin();
    QVERIFY(!opening.views().isVisible());
    opening.end();
    QVERIFY(opening.views().isVisible());
}

void EarlySliceUiTest::abortedItIsGone()
{
    Opening opening(test::plainCt(test::headFirstSupine()));
    QSignalSpy loaded(&opening.opener(), &ui::StudyOpener::loaded);
    opening.begin();
    auto* bar = opening.fixture.window.findChild<ui::LoadingBar*>();
    QTest::mouseClick(bar->findChild<QPushButton*>(), Qt::LeftButton);
    QVERIFY(!opening.views().isVisible());
    QVERIFY(opening.views().axial().picture().isNull());
    QVERIFY(!bar->isVisible());
    QVERIFY(!opening.fixture.window.messages().isVisible());
    QCOMPARE(opening.fixture.window.windowTitle(), QStringLiteral("Burin"));
    opening.goOn();
    // Another study goes its way, and nothing comes of the first.
    core::LoadedVolume other = test::plainCt(test::headFirstProne());
    const glm::dmat4 itsOwn = other.volume.geometry.indexToWorld;
    opening.opener().run(somewhere, [&other](const auto&, const auto&) { return other; });
    QTRY_VERIFY(opening.fixture.workspace.volume());
    QCOMPARE(opening.fixture.workspace.volume()->geometry.indexToWorld, itsOwn);
    QCOMPARE(loaded.size(), 1);
}

void EarlySliceUiTest::closingTheStudyAborts()
{
    Opening opening(test::plainCt(test::headFirstSupine()));
    QAction& close = opening.fixture.window.actionTable()[QStringLiteral("file.close")];
    QVERIFY(!close.isEnabled());
    opening.begin();
    QVERIFY(close.isEnabled());
    close.trigger();
    QVERIFY(!opening.opener().busy());
    QVERIFY(!opening.views().isVisible());
    QVERIFY(!close.isEnabled());
}

void EarlySliceUiTest::failingLeavesAMessage()
{
    core::LoadedVolume volume = test::plainCt(test::headFirstSupine());
    volume.volume.problems = {{core::VolumeProblem::Kind::Tilt,
        {core::ProblemCode::AsStored, {QStringLiteral("The slices are tilted by 12°.")}}, true}};
    Opening opening(std::move(volume));
    opening.begin(core::Error{core::ErrorCode::OutOfMemory, {QStringLiteral("12 × 12 × 12")}});
    QVERIFY(opening.views().isVisible());
    opening.end();
    QVERIFY(!opening.fixture.workspace.volume());
    QVERIFY(!opening.views().isVisible());
    QVERIFY(opening.views().axial().picture().isNull());
    QVERIFY(opening.fixture.window.messages().isVisible());
    const QString said = opening.fixture.window.messages().sentence();
    QVERIFY2(said.contains(QStringLiteral("12 × 12 × 12")), qPrintable(said));
}

void EarlySliceUiTest::anOpenStudyStays()
{
    core::LoadedVolume next = test::plainCt(test::headFirstSupine());
    next.volume.identity.patientName = QStringLiteral("NEXT^ONE");
    Opening opening(std::move(next), true);
    const core::Volume* open = opening.fixture.workspace.volume();
    const QImage shown = opening.views().axial().picture();
    opening.begin();
    QCOMPARE(opening.fixture.workspace.volume(), open);
    QCOMPARE(opening.views().axial().picture(), shown);
    QVERIFY(opening.fixture.window.windowTitle().contains(QStringLiteral("TEST, WINDOW")));
    for (const auto* section : opening.fixture.window.findChildren<ui::PanelSection*>())
        QVERIFY(section->isEnabled());
    opening.end();
    QVERIFY(opening.fixture.window.windowTitle().contains(QStringLiteral("NEXT, ONE")));
}

void EarlySliceUiTest::closingTheWindowAborts()
{
    const core::LoadedVolume volume = test::plainCt(test::headFirstSupine());
    auto fixture = std::make_unique<test::WindowFixture>(volume);
    fixture->workspace.setSession(nullptr);
    QSignalSpy told(&fixture->window.opener(), &ui::StudyOpener::sliceReady);
    bool ended = false;
    fixture->window.opener().run(somewhere,
        [&](const core::Progress& progress,
            const core::EarlySliceListener& listener) -> core::Result<core::LoadedVolume> {
            listener(middleOf(volume));
            while (!progress.cancelled())
                std::this_thread::yield();
            ended = true;
            return core::failure(core::ErrorCode::Cancelled);
        });
    QTRY_COMPARE(told.size(), 1);
    QVERIFY(fixture->window.close());
    // The window's members are gone one by one when its opener ends.
    int finished = 0;
    connect(&fixture->window.opener(), &ui::StudyOpener::finished, this, [&] { ++finished; });
    fixture.reset();
    QVERIFY(ended);
    QCOMPARE(finished, 0);
}

BURIN_WINDOW_TEST(EarlySliceUiTest)

} // namespace earlySliceUiTest

#include "EarlySliceUiTest.moc"
