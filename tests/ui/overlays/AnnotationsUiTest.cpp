// SPDX-License-Identifier: Apache-2.0
#include "ui/overlays/Annotations.h"

#include "tests/support/fixtures/WindowFixture.h"
#include "tests/support/program/TestProgram.h"
#include "ui/base/Theme.h"
#include "ui/views/ViewGrid.h"

#include <QFontMetrics>
#include <QTest>

namespace annotationsUiTest {

namespace {

bool differsIn(const QImage& a, const QImage& b, const QRect& box)
{
    for (int y = box.top(); y <= box.bottom(); ++y) {
        for (int x = box.left(); x <= box.right(); ++x) {
            if (a.rect().contains(x, y) && a.pixel(x, y) != b.pixel(x, y))
                return true;
        }
    }
    return false;
}

/// An axial slice without and with the crosshair, which goes through a pixel.
class Crossed {
public:
    void lay(const QPoint& through)
    {
        const glm::dvec3 place = axial.context().toLps(QPointF(through) + QPointF(0.5, 0.5));
        fixture.workspace.setCrosshairLps(place);
        const QPointF at = axial.crosshairPixel() - QPointF(through);
        QVERIFY(at.manhattanLength() < 3.0);
        without = seen(false);
        with = seen(true);
    }
    /// Whether the crosshair is seen there.
    [[nodiscard]] bool isIn(const QRect& box) const { return differsIn(without, with, box); }

    test::WindowFixture fixture{test::headFirstSupine()};
    ui::SliceView& axial = fixture.window.views().axial();

private:
    [[nodiscard]] QImage seen(bool crosshair)
    {
        ui::Workspace::ViewOptions options = fixture.workspace.viewOptions();
        options.showCrosshair = crosshair;
        fixture.workspace.setViewOptions(options);
        QCoreApplication::processEvents();
        return axial.grab().toImage().convertToFormat(QImage::Format_RGB32);
    }

    QImage without;
    QImage with;
};

} // namespace

class AnnotationsUiTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    /// All four letters stand where the lines of a crosshair in the middle pass.
    void theCrosshairLeavesLettersFree()
    {
        Crossed crossed;
        const QRect view = crossed.axial.rect();
        const QPoint middle = view.center();
        crossed.lay(middle);
        QFont font = ui::theme::bodyFont();
        font.setWeight(QFont::Bold);
        const QFontMetrics metrics(font);
        const int height = metrics.height();
        const auto width = [&metrics](QChar letter) { return metrics.horizontalAdvance(letter); };
        const int aside = width(u'A') / 2;
        const QRect above(middle.x() - aside, 9, width(u'A'), height);
        QVERIFY(!crossed.isIn(above));
        QVERIFY(!crossed.isIn(
            QRect(middle.x() - aside, view.height() - 8 - height, width(u'P'), height)));
        QVERIFY(!crossed.isIn(QRect(8, middle.y() - height / 2, width(u'R'), height)));
        QVERIFY(!crossed.isIn(
            QRect(view.width() - 8 - width(u'L'), middle.y() - height / 2, width(u'L'), height)));
        // Close to them the lines go on; dashes are nine pixels apart.
        QVERIFY(crossed.isIn(QRect(middle.x() - 3, above.bottom() + 5, 7, 12)));
        QVERIFY(crossed.isIn(QRect(8 + width(u'R') + 6, middle.y() - 3, 12, 7)));
    }

    void theCrosshairLeavesCornersFree()
    {
        Crossed crossed;
        const QRect view = crossed.axial.rect();
        const int title =
            QFontMetrics(ui::theme::headingFont()).horizontalAdvance(crossed.axial.title());
        crossed.lay({view.center().x() + 60, 17});
        QVERIFY(!crossed.isIn(QRect(ui::theme::padding, 10, title, 15)));
        QVERIFY(crossed.isIn(QRect(ui::theme::padding + title + 6, 14, 12, 7)));
        // The slice's number, whose text is longer than this.
        crossed.lay({view.center().x() + 60, view.height() - 18});
        constexpr int shorter = 40;
        QVERIFY(!crossed.isIn(
            QRect(view.width() - ui::theme::padding - shorter, view.height() - 25, shorter, 15)));
    }
};

BURIN_WINDOW_TEST(AnnotationsUiTest)

} // namespace annotationsUiTest

#include "AnnotationsUiTest.moc"
