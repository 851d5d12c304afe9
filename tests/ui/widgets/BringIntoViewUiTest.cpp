// SPDX-License-Identifier: Apache-2.0
#include "tests/support/faults/FailingLog.h"
#include "tests/support/program/TestProgram.h"
#include "ui/widgets/BringIntoView.h"

#include <QLabel>
#include <QScrollArea>
#include <QVBoxLayout>
#include <QtTest>

namespace bringIntoViewUiTest {

namespace {

QWidget* blockIn(QWidget& parent, int height)
{
    auto* block = new QWidget(&parent);
    block->setFixedHeight(height);
    parent.layout()->addWidget(block);
    return block;
}

/// @return a widget with a layout of its own in that of its parent
QWidget* nested(QWidget& parent)
{
    auto* inner = new QWidget(&parent);
    auto* layout = new QVBoxLayout(inner);
    layout->setContentsMargins(0, 0, 0, 0);
    if (parent.layout())
        parent.layout()->addWidget(inner);
    return inner;
}

} // namespace

class BringIntoViewUiTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnUnexpectedMessages(); }

    /// A question that appears deep in a panel, while the panel above it grows, too.
    void whatHasJustBeenShown_data()
    {
        QTest::addColumn<bool>("atOnce");
        QTest::newRow("at once") << true;
        QTest::newRow("after the events that are there") << false;
    }
    void whatHasJustBeenShown()
    {
        QFETCH(const bool, atOnce);
        QScrollArea area;
        area.setWidgetResizable(true);
        area.resize(300, 300);
        auto* column = new QWidget;
        new QVBoxLayout(column);
        area.setWidget(column);
        QWidget* first = nested(*nested(*column));
        blockIn(*first, 250);
        QWidget* more = blockIn(*first, 60);
        QWidget* panel = nested(*nested(*nested(*column)));
        blockIn(*panel, 100);
        QWidget* question = nested(*panel);
        QWidget* head = blockIn(*question, 40);
        QWidget* buttons = blockIn(*question, 30);
        blockIn(*panel, 400);
        more->hide();
        question->hide();
        area.show();
        QVERIFY(QTest::qWaitForWindowExposed(&area));

        more->show();
        question->show();
        if (!atOnce)
            QCoreApplication::processEvents();
        ui::bringIntoView(*question, *head);
        QCoreApplication::processEvents();
        const auto isSeen = [&area](const QWidget& widget) {
            const QRect place(widget.mapTo(area.viewport(), QPoint()), widget.size());
            return area.viewport()->rect().contains(place);
        };
        QVERIFY(isSeen(*head));
        QVERIFY(isSeen(*buttons));
    }
};

BURIN_WINDOW_TEST(BringIntoViewUiTest)

} // namespace bringIntoViewUiTest

#include "BringIntoViewUiTest.moc"
