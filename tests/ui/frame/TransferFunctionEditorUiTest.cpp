// SPDX-License-Identifier: Apache-2.0
#include "tests/support/program/TestProgram.h"
#include "ui/frame/TransferFunctionEditor.h"

#include "ui/settings/TransferPresets.h"
#include "ui/workspace/InitialDisplay.h"

#include <QSignalSpy>
#include <QtTest>

#include <algorithm>
#include <cmath>

namespace transferFunctionEditorUiTest {

using ui::TransferFunctionEditor;

class TransferFunctionEditorUiTest : public QObject {
    Q_OBJECT

private:
    static void prepare(TransferFunctionEditor& editor)
    {
        editor.setHistogram({-1000.0, 3000.0, std::vector<std::uint32_t>(200, 3)});
        editor.setFunction(
            {{{0.0, 0x101010, 0.0}, {1000.0, 0x808080, 0.25}, {2000.0, 0xffffff, 1.0}}});
        editor.resize(400, 84);
        editor.show();
        QVERIFY(QTest::qWaitForWindowExposed(&editor));
    }
    static QPoint at(const TransferFunctionEditor& editor, std::size_t point)
    {
        return editor.positionOf(editor.function().points[point]).toPoint();
    }

private Q_SLOTS:
    void aPointIsDraggedBetweenItsNeighbours()
    {
        TransferFunctionEditor editor;
        prepare(editor);
        QSignalSpy edited(&editor, &TransferFunctionEditor::functionEdited);
        const QPoint from = at(editor, 1);
        QTest::mousePress(&editor, Qt::LeftButton, {}, from);
        QTest::mouseMove(&editor, from + QPoint(30, -10));
        QVERIFY(edited.count() > 0);
        QVERIFY(editor.function().points[1].value > 1200.0);
        QVERIFY(editor.function().points[1].opacity > 0.25);
        QTest::mouseMove(&editor, QPoint(editor.width() - 2, 200));
        QTest::mouseRelease(&editor, Qt::LeftButton, {}, QPoint(editor.width() - 2, 200));
        QCOMPARE(editor.function().points[1].value, 2000.0);
        QCOMPARE(editor.function().points[1].opacity, 0.0);
        QCOMPARE(editor.function().points[1].rgb, 0x808080u);
    }

    void pointsAreAddedAndRemoved()
    {
        TransferFunctionEditor editor;
        prepare(editor);
        const QPoint empty(int(std::lround(editor.xOf(500.0))), 12);
        QTest::mouseDClick(&editor, Qt::LeftButton, {}, empty);
        QCOMPARE(editor.function().points.size(), std::size_t(4));
        QVERIFY(std::abs(editor.function().points[1].value - 500.0) < 20.0);
        QTest::mouseRelease(&editor, Qt::LeftButton, {}, empty);
        QTest::keyClick(&editor, Qt::Key_Delete);
        QCOMPARE(editor.function().points.size(), std::size_t(3));
        for (int i = 0; i < 3; ++i) {
            QTest::mouseClick(&editor, Qt::LeftButton, {}, at(editor, 0));
            QTest::keyClick(&editor, Qt::Key_Delete);
        }
        QCOMPARE(editor.function().points.size(), std::size_t(2)); // a ramp is the least
    }

    void presetsAscend_data()
    {
        QTest::addColumn<QString>("unit");
        QTest::newRow("CT") << QStringLiteral("HU");
        QTest::newRow("MR") << QString();
    }
    void presetsAscend()
    {
        QFETCH(QString, unit);
        core::Volume volume;
        volume.unit = unit;
        volume.minimum = 0.0;
        volume.maximum = 1000.0;
        volume.histogram = {0.0, 1000.0, std::vector<std::uint32_t>(100, 10)};
        const auto presets = ui::transferPresets(volume);
        QVERIFY(presets.size() >= 2);
        for (const ui::TransferPreset& preset : presets) {
            QVERIFY(preset.function.points.size() >= 2);
            for (std::size_t i = 1; i < preset.function.points.size(); ++i)
                QVERIFY(preset.function.points[i - 1].value < preset.function.points[i].value);
            for (const auto& point : preset.function.points)
                QVERIFY(point.opacity >= 0.0 && point.opacity <= 1.0);
        }
        QCOMPARE(ui::quantile(volume.histogram, 0.5), 500.0);
    }
    /// A few voxels that are ten times as bright as tissue do not darken it: a value in its middle
    /// is seen within centimetres, in a bright colour.
    void outliersDoNotDarkenTissue()
    {
        core::Volume volume;
        volume.minimum = 0.0;
        volume.maximum = 4000.0;
        volume.histogram = {0.0, 4000.0, std::vector<std::uint32_t>(400, 0)};
        for (std::size_t bin = 0; bin < 400; ++bin)
            volume.histogram.counts[bin] = bin < 4 ? 100000 : bin >= 20 && bin < 40 ? 9000 : 0;
        volume.histogram.counts[399] = 40;
        for (const ui::TransferPreset& preset : ui::transferPresets(volume))
            QVERIFY2(preset.function.points.back().value < 500.0, qPrintable(preset.name));
        const std::vector<gpu::TransferFunction::Point> points =
            ui::transferPresets(volume).front().function.points;
        QVERIFY(points.front().value > 0.0 && points.front().value < 200.0);
        const auto middle = std::find_if(points.begin(), points.end(),
            [](const gpu::TransferFunction::Point& point) { return point.value >= 300.0; });
        QVERIFY(middle != points.end() && middle->opacity >= 0.03);
        QVERIFY((middle->rgb >> 16 & 255) > 180);
        QVERIFY(ui::initialVolumeDisplay(volume).transferFunction
            == ui::transferPresets(volume).front().function);
        // To a bin, and apart from the outliers.
        QVERIFY(std::abs(ui::quantileAbove(volume.histogram, 200.0, 0.5) - 300.0) <= 10.0);
    }

    void aConstantVolumeIsNotSeen_data()
    {
        QTest::addColumn<double>("value");
        QTest::addColumn<double>("range");
        for (const double value : {0.0, 1000.0, -1000.0, 3e9}) {
            QTest::addRow("%g, no range", value) << value << 0.0;
            QTest::addRow("%g, a range of 1", value) << value << 1.0;
        }
    }
    void aConstantVolumeIsNotSeen()
    {
        QFETCH(double, value);
        QFETCH(double, range);
        core::Volume volume;
        volume.minimum = value;
        volume.maximum = value + range;
        volume.histogram = {value, value + range, std::vector<std::uint32_t>(256, 0)};
        volume.histogram.counts[0] = 5000;
        for (const ui::TransferPreset& preset : ui::transferPresets(volume)) {
            const std::vector<gpu::TransferFunction::Point>& points = preset.function.points;
            // Up to the first point the opacity is that of the first.
            QVERIFY2(points[0].value >= value && points[0].opacity == 0.0, qPrintable(preset.name));
            for (std::size_t i = 1; i < points.size(); ++i)
                QVERIFY2(points[i - 1].value < points[i].value, qPrintable(preset.name));
        }
    }

    void aboveAllValuesIsTheMaximum()
    {
        core::Histogram histogram{0.0, 100.0, std::vector<std::uint32_t>(10, 0)};
        histogram.counts[0] = 7;
        QCOMPARE(ui::quantileAbove(histogram, 50.0, 0.5), 100.0);
        QCOMPARE(ui::quantileAbove(histogram, 200.0, 0.5), 200.0);
    }

    /// A quarter of a metre of soft tissue is a haze through which bone is seen.
    void softTissueOfCtIsAHaze()
    {
        core::Volume volume;
        volume.unit = QStringLiteral("HU");
        const std::vector<gpu::TransferFunction::Point> points =
            ui::transferPresets(volume).front().function.points;
        const auto opacity = [&points](double hu) {
            double found = 0.0;
            for (std::size_t i = 1; i < points.size(); ++i) {
                const auto& [from, fromRgb, fromOpacity] = points[i - 1];
                const auto& [to, toRgb, toOpacity] = points[i];
                if (hu >= from && hu <= to)
                    found = fromOpacity + (toOpacity - fromOpacity) * (hu - from) / (to - from);
            }
            return found;
        };
        for (const double hu : {-100.0, 0.0, 40.0})
            QVERIFY(std::pow(1.0 - opacity(hu), 250.0) > 0.35);
        QVERIFY(std::pow(1.0 - opacity(400.0), 4.0) < 0.2);
    }
};

BURIN_WINDOW_TEST(TransferFunctionEditorUiTest)

} // namespace transferFunctionEditorUiTest

#include "TransferFunctionEditorUiTest.moc"
