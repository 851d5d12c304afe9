// SPDX-License-Identifier: Apache-2.0
#include "tests/support/faults/FailingLog.h"
#include "tests/support/program/TestProgram.h"
#include "ui/base/Theme.h"
#include "ui/frame/StartPage.h"

#include <QLabel>
#include <QPushButton>
#include <QtTest>

namespace startPageUiTest {

/// What the page before a study shows, at whatever width.
class StartPageUiTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { ui::theme::apply(*qApp); }
    void init() { test::failOnUnexpectedMessages(); }

    void noWordIsCut_data()
    {
        QTest::addColumn<int>("width");
        for (const int width : {420, 640, 1280, 1920})
            QTest::addRow("%d wide", width) << width;
    }
    void noWordIsCut()
    {
        QFETCH(int, width);
        ui::StartPage page;
        page.resize(width, 900);
        page.show();
        QVERIFY(QTest::qWaitForWindowExposed(&page));
        const QList<QPushButton*> choices = page.findChildren<QPushButton*>("choice");
        QCOMPARE(choices.size(), 3);
        for (const QPushButton* choice : choices) {
            for (const QLabel* label : choice->findChildren<QLabel*>()) {
                if (label->text().isEmpty())
                    continue;
                QVERIFY2(label->height() >= label->heightForWidth(label->width()),
                    qPrintable(label->text()));
                QVERIFY2(choice->rect().contains(label->geometry()), qPrintable(label->text()));
            }
        }
    }
};

BURIN_WINDOW_TEST(StartPageUiTest)

} // namespace startPageUiTest

#include "StartPageUiTest.moc"
