// SPDX-License-Identifier: Apache-2.0
#include "tests/support/faults/FailingLog.h"
#include "tests/support/program/TestProgram.h"
#include "ui/widgets/HistogramPlot.h"
#include "ui/widgets/fields/FieldManners.h"

#include <QAction>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLineEdit>
#include <QScrollArea>
#include <QScrollBar>
#include <QSignalSpy>
#include <QSlider>
#include <QTest>
#include <QVBoxLayout>
#include <QWheelEvent>

#include <optional>

namespace fieldMannersUiTest {

/// What one did not mean does not happen: the wheel over a panel, keys in a number field.
class FieldMannersUiTest : public QObject {
    Q_OBJECT

    struct Panel {
        QScrollArea area;
        QDoubleSpinBox* number = new QDoubleSpinBox;
        QComboBox* list = new QComboBox;
        QSlider* slider = new QSlider(Qt::Horizontal);
        ui::HistogramPlot* histogram = new ui::HistogramPlot;
        QLineEdit* name = new QLineEdit;
        QAction undo{QStringLiteral("Undo")};
        QAction hide{QStringLiteral("Hide")};

        Panel()
        {
            auto* content = new QWidget;
            auto* layout = new QVBoxLayout(content);
            number->setRange(0.0, 100.0);
            number->setValue(50.0);
            list->addItems({QStringLiteral("a"), QStringLiteral("b"), QStringLiteral("c")});
            list->setCurrentIndex(1);
            slider->setValue(50);
            histogram->setHistogram({0.0, 1000.0, std::vector<std::uint32_t>(100, 5)});
            for (QWidget* each :
                std::initializer_list<QWidget*>{number, list, slider, histogram, name})
                layout->addWidget(each);
            content->setMinimumHeight(2000);
            area.setWidget(content);
            area.setWidgetResizable(true);
            undo.setShortcut(QKeySequence::Undo);
            hide.setShortcut(Qt::Key_H);
            area.addActions({&undo, &hide});
            area.resize(300, 300);
            area.show();
        }
    };
    std::optional<ui::FieldManners> m_manners;
    std::optional<Panel> m_panel;

    static void wheelOver(QWidget& widget, Qt::KeyboardModifiers keys = Qt::NoModifier)
    {
        const QPointF at = QRectF(widget.rect()).center();
        QWheelEvent event(at, widget.mapToGlobal(at), {}, {0, -120}, Qt::NoButton, keys,
            Qt::NoScrollPhase, false);
        // As the window system tells it: only such ones go on to the parent.
        QSpontaneKeyEvent::setSpontaneous(&event);
        qApp->notify(&widget, &event);
    }

private Q_SLOTS:
    void init()
    {
        test::failOnUnexpectedMessages();
        m_manners.emplace();
        qApp->installEventFilter(&*m_manners);
        m_panel.emplace();
        m_panel->area.activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(&m_panel->area));
    }
    void cleanup()
    {
        m_panel.reset();
        m_manners.reset();
    }

    void theWheelScrollsThePanel()
    {
        Panel& panel = *m_panel;
        panel.name->setFocus();
        int scrolled = panel.area.verticalScrollBar()->value();
        for (QWidget* field :
            std::initializer_list<QWidget*>{panel.number, panel.list, panel.slider}) {
            wheelOver(*field);
            QVERIFY2(panel.area.verticalScrollBar()->value() > scrolled,
                field->metaObject()->className());
            scrolled = panel.area.verticalScrollBar()->value();
            QVERIFY(!field->hasFocus());
            QVERIFY(field->focusPolicy() != Qt::WheelFocus);
        }
        QCOMPARE(panel.number->value(), 50.0);
        QCOMPARE(panel.list->currentIndex(), 1);
        QCOMPARE(panel.slider->value(), 50);
    }

    void theWheelTurnsWhatHasTheFocus()
    {
        Panel& panel = *m_panel;
        panel.number->setFocus();
        wheelOver(*panel.number);
        QCOMPARE(panel.number->value(), 49.0);
        // But no list that is folded up: a panel that is scrolled would change what is drawn.
        panel.list->setFocus();
        wheelOver(*panel.list);
        QCOMPARE(panel.list->currentIndex(), 1);
    }

    void aHistogramIsZoomedByWhoMeansIt()
    {
        Panel& panel = *m_panel;
        ui::HistogramPlot& plot = *panel.histogram;
        const auto shown = [&plot] {
            return plot.valueAt(plot.width() - 10.0) - plot.valueAt(10.0);
        };
        plot.showValues(400.0, 600.0);
        const double before = shown();
        panel.name->setFocus();
        wheelOver(plot);
        QVERIFY(panel.area.verticalScrollBar()->value() > 0);
        QCOMPARE(shown(), before);
        const int scrolled = panel.area.verticalScrollBar()->value();
        wheelOver(plot, Qt::ControlModifier);
        const double wider = shown();
        QVERIFY(wider > before);
        plot.setFocus();
        wheelOver(plot);
        QVERIFY(shown() > wider);
        QCOMPARE(panel.area.verticalScrollBar()->value(), scrolled);
    }

    void keysOfTheWindowReachIt()
    {
        Panel& panel = *m_panel;
        const QSignalSpy undone(&panel.undo, &QAction::triggered);
        const QSignalSpy hidden(&panel.hide, &QAction::triggered);
        panel.number->setFocus();
        panel.number->selectAll();
        QTest::keyClicks(panel.number, QStringLiteral("7"));
        QTest::keyClick(panel.number, Qt::Key_Z, Qt::ControlModifier);
        QCOMPARE(undone.size(), 1);
        QTest::keyClick(panel.number, Qt::Key_H);
        QCOMPARE(hidden.size(), 1);
        QCOMPARE(panel.number->value(), 7.0);
        // Where words are written both are the field's.
        panel.name->setFocus();
        QTest::keyClicks(panel.name, QStringLiteral("Hh"));
        QTest::keyClick(panel.name, Qt::Key_Z, Qt::ControlModifier);
        QCOMPARE(undone.size(), 1);
        QCOMPARE(hidden.size(), 1);
    }
};

BURIN_WINDOW_TEST(FieldMannersUiTest)

} // namespace fieldMannersUiTest

#include "FieldMannersUiTest.moc"
