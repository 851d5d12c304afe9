// SPDX-License-Identifier: Apache-2.0
#include "core/session/EditSession.h"
#include "tests/reference/ReferenceEngine.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/fixtures/WindowFixture.h"
#include "tests/support/fixtures/frames/FrameTest.h"
#include "tests/support/program/TestProgram.h"
#include "ui/views/ViewGrid.h"

#include <QCoreApplication>
#include <QTest>

#include <algorithm>
#include <cstdint>

namespace nextVolumeUiTest {

namespace {

constexpr std::uint16_t dark = 1000;
constexpr std::uint16_t bright = 1200;

/// Volumes that differ in their values alone: views ask for the same pictures of them.
core::LoadedVolume uniform(std::uint16_t code)
{
    core::LoadedVolume loaded = test::plainCt(test::headFirstSupine());
    std::fill(loaded.codes.begin(), loaded.codes.end(), code);
    return loaded;
}

/// The views over what draws for them. That has a volume before the workspace shows it, as while a
/// study is opened.
class Views {
public:
    explicit Views(test::FrameFixture& drawing)
        : m_drawing(drawing)
        , workspace(drawing.scheduler)
        , grid(workspace)
    {
        grid.resize(420, 320);
        grid.maximise(&grid.axial());
    }
    void draw(std::uint16_t code)
    {
        const core::LoadedVolume loaded = uniform(code);
        m_drawing.open(
            loaded.volume.geometry, [code](const glm::dvec3&) { return double(code); },
            loaded.volume.encoding);
    }
    void show(std::uint16_t code)
    {
        auto session = core::EditSession::create(m_engine, uniform(code), {});
        if (!session)
            qFatal("the session could not be made");
        workspace.setSession(std::move(*session));
    }
    /// Opens the first volume, and waits for its pictures.
    void begin()
    {
        draw(dark);
        show(dark);
        grid.show();
        if (!QTest::qWaitForWindowExposed(&grid) || !isDrawn())
            qFatal("the views show nothing");
    }
    [[nodiscard]] bool isDrawn()
    {
        return QTest::qWaitFor(
            [this] {
                m_drawing.settle();
                QCoreApplication::processEvents();
                return grid.refined();
            },
            60000);
    }
    [[nodiscard]] gpu::Scene scene() const { return grid.axial().context().scene; }
    /// In the middle, where the volume is.
    [[nodiscard]] int grey() const
    {
        const QImage& picture = grid.axial().picture();
        return picture.isNull() ? -1 : qGray(picture.pixel(picture.rect().center()));
    }

private:
    test::FrameFixture& m_drawing;
    reference::ReferenceEngine m_engine;

public:
    ui::Workspace workspace;
    ui::ViewGrid grid;
};

} // namespace

/// Views over what really draws, turn by turn, so that each order of opening and drawing can be
/// had.
class NextVolumeUiTest : public test::FrameTest {
    Q_OBJECT

private Q_SLOTS:
    void init()
    {
        test::failOnUnexpectedMessages();
        m_fixture.emplace();
    }
    void aPictureThatNobodyTookIsDrawnAgain();
    void aWaitingPictureOfTheLastOneIsNotShown();
    void nothingIsDrawnForAClosedStudy();
};

/// On a busy machine a picture of the next volume is done before the workspace shows that volume.
void NextVolumeUiTest::aPictureThatNobodyTookIsDrawnAgain()
{
    Views views(*m_fixture);
    views.begin();
    const int before = views.grey();
    QVERIFY(before > 0);
    const gpu::Scene asked = views.scene();
    views.grid.holdPictures(QStringLiteral("the next one"));
    QVERIFY(views.grid.holdsPictures());

    views.workspace.setSession(nullptr);
    views.draw(bright);
    m_fixture->settle();
    QCoreApplication::processEvents();
    QVERIFY(views.grid.axial().picture().isNull() && views.grid.holdsPictures());
    views.show(bright);
    QVERIFY(views.scene() == asked); // else it would be drawn anyway
    QVERIFY(views.isDrawn());
    QVERIFY(!views.grid.holdsPictures());
    QVERIFY2(views.grey() > before + 50, qPrintable(QString::number(views.grey())));
}

void NextVolumeUiTest::aWaitingPictureOfTheLastOneIsNotShown()
{
    Views views(*m_fixture);
    views.begin();
    core::WindowLevel window = views.workspace.windowLevel();
    window.width *= 0.5;
    views.workspace.setWindowLevel(window);
    m_fixture->settle(); // now its picture waits
    views.grid.holdPictures(QStringLiteral("the next one"));

    views.workspace.setSession(nullptr);
    views.draw(bright);
    views.show(bright);
    QCoreApplication::processEvents();
    QVERIFY(views.grid.axial().picture().isNull() && views.grid.holdsPictures());
    QVERIFY(views.isDrawn());
    QVERIFY(!views.grid.holdsPictures());
}

/// Neither slices nor the 3D view for either eye.
void NextVolumeUiTest::nothingIsDrawnForAClosedStudy()
{
    Views views(*m_fixture);
    views.grid.maximise(nullptr);
    views.grid.volume().setStereo({.mode = ui::Stereo::Mode::Anaglyph});
    views.begin();
    views.workspace.setSession(nullptr);
    m_fixture->settle();
    const std::int64_t tiles = m_fixture->scheduler.counters().tiles;
    QVERIFY(tiles > 0);
    views.draw(bright);
    m_fixture->settle();
    QCOMPARE(m_fixture->scheduler.counters().tiles, tiles);
    views.show(bright);
    QVERIFY(views.isDrawn());
}

BURIN_WINDOW_TEST(NextVolumeUiTest)

} // namespace nextVolumeUiTest

#include "NextVolumeUiTest.moc"
