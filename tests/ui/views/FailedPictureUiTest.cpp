// SPDX-License-Identifier: Apache-2.0
#include "tests/support/fixtures/WindowFixture.h"
#include "tests/support/program/TestProgram.h"
#include "ui/views/ViewGrid.h"

#include <QCoreApplication>
#include <QTest>

namespace failedPictureUiTest {

class FailedPictureUiTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void itIsAskedForAgain();
};

/// Of a picture that the graphics processor could not draw, the next occasion asks again, though
/// nothing else has changed.
void FailedPictureUiTest::itIsAskedForAgain()
{
    test::WindowFixture fixture(test::headFirstSupine());
    const ui::ViewGrid& grid = fixture.window.views();
    const gpu::ViewId axial = fixture.window.views().axial().viewId();
    const gpu::ViewId coronal = fixture.window.views().coronal().viewId();
    const core::Error why{core::ErrorCode::OutOfMemory, {QStringLiteral("a picture")}};
    // The message that it failed takes its room now, so that no view changes its size later.
    fixture.workspace.fail(why);
    QCoreApplication::processEvents();
    QTRY_VERIFY(grid.refined());

    const int before = fixture.frames.requestCount(axial);
    const int others = fixture.frames.requestCount(coronal);
    QVERIFY(before > 0);
    Q_EMIT fixture.workspace.windowLevelChanged();
    QCOMPARE(fixture.frames.requestCount(axial), before); // it has that picture
    const gpu::Scene scene = fixture.frames.lastRequest(axial).scene;
    fixture.frames.fail(axial, why);
    QCoreApplication::processEvents();
    Q_EMIT fixture.workspace.windowLevelChanged();
    QCOMPARE(fixture.frames.requestCount(axial), before + 1);
    QVERIFY(fixture.frames.lastRequest(axial).scene == scene);
    QCOMPARE(fixture.frames.requestCount(coronal), others);
    Q_EMIT fixture.workspace.windowLevelChanged();
    QCOMPARE(fixture.frames.requestCount(axial), before + 1);
}

BURIN_WINDOW_TEST(FailedPictureUiTest)

} // namespace failedPictureUiTest

#include "FailedPictureUiTest.moc"
