// SPDX-License-Identifier: Apache-2.0
#include "ui/widgets/fields/FieldMenu.h"

#include "tests/support/faults/FailingLog.h"
#include "tests/support/program/TestProgram.h"
#include "ui/widgets/fields/NumberField.h"

#include <QApplication>
#include <QCheckBox>
#include <QVBoxLayout>
#include <QtTest>

namespace fieldMenuUiTest {

namespace {

/// An open menu with a box, a field that is greyed and two others.
struct Fixture {
    Fixture()
    {
        auto* form = new QWidget;
        auto* rows = new QVBoxLayout(form);
        box = new QCheckBox(QStringLiteral("limits"), form);
        greyed = new ui::NumberField(form);
        lower = new ui::NumberField(form);
        upper = new ui::NumberField(form);
        for (QWidget* each : std::initializer_list<QWidget*>{box, greyed, lower, upper})
            rows->addWidget(each);
        greyed->setEnabled(false);
        for (ui::NumberField* each : {lower, upper})
            each->setRange(0.0, 5000.0);
        menu = new ui::FieldMenu(form, &window);
        window.show();
        menu->popup(window.mapToGlobal(QPoint(0, 0)));
    }
    /// Presses a key where the keyboard is.
    void press(Qt::Key key, Qt::KeyboardModifiers modifiers = Qt::NoModifier)
    {
        QWidget* focused = menu->focusWidget();
        QTest::keyClick(focused ? focused : menu, key, modifiers);
    }

    QWidget window;
    ui::FieldMenu* menu = nullptr;
    QCheckBox* box = nullptr;
    ui::NumberField* greyed = nullptr;
    ui::NumberField* lower = nullptr;
    ui::NumberField* upper = nullptr;
};

} // namespace

class FieldMenuUiTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnUnexpectedMessages(); }

    void tabGoesFromFieldToField()
    {
        Fixture f;
        QTRY_VERIFY(f.menu->isVisible());
        for (QWidget* expected : std::initializer_list<QWidget*>{f.box, f.lower, f.upper, f.box}) {
            f.press(Qt::Key_Tab);
            QCOMPARE(f.menu->focusWidget(), expected);
        }
        for (QWidget* expected : std::initializer_list<QWidget*>{f.upper, f.lower}) {
            f.press(Qt::Key_Backtab, Qt::ShiftModifier);
            QCOMPARE(f.menu->focusWidget(), expected);
        }
        QVERIFY(f.menu->isVisible());
    }

    /// Who types one limit, Tab and the other one has typed both.
    void twoNumbersInARow()
    {
        Fixture f;
        QTRY_VERIFY(f.menu->isVisible());
        f.press(Qt::Key_Tab);
        f.press(Qt::Key_Tab);
        QTest::keyClicks(f.menu->focusWidget(), QStringLiteral("800"));
        f.press(Qt::Key_Tab);
        QTest::keyClicks(f.menu->focusWidget(), QStringLiteral("1500"));
        f.press(Qt::Key_Tab);
        QCOMPARE(f.lower->value(), 800.0);
        QCOMPARE(f.upper->value(), 1500.0);
    }

    /// On a greyed field and in the margin; only one beside the menu closes it.
    void clicksBesideTheFields()
    {
        Fixture f;
        QTRY_VERIFY(f.menu->isVisible());
        QTest::mouseClick(f.greyed, Qt::LeftButton);
        QTest::mouseClick(f.greyed->parentWidget(), Qt::LeftButton, {}, QPoint(2, 2));
        QTest::qWait(50);
        QVERIFY(f.menu->isVisible());
        QTest::mouseClick(f.menu, Qt::LeftButton, {}, QPoint(-20, -20));
        QTRY_VERIFY(!f.menu->isVisible());
    }

    void escapeClosesIt()
    {
        Fixture f;
        QTRY_VERIFY(f.menu->isVisible());
        f.press(Qt::Key_Tab);
        f.press(Qt::Key_Escape);
        QTRY_VERIFY(!f.menu->isVisible());
    }
};

BURIN_WINDOW_TEST(FieldMenuUiTest)

} // namespace fieldMenuUiTest

#include "FieldMenuUiTest.moc"
