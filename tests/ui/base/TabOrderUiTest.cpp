// SPDX-License-Identifier: Apache-2.0
#include "tests/support/fixtures/TabWalk.h"
#include "tests/support/fixtures/WindowFixture.h"
#include "tests/support/program/TestProgram.h"
#include "ui/base/TabOrder.h"
#include "ui/dialogs/CodeDialog.h"
#include "ui/dialogs/export/ExportDialog.h"
#include "ui/pacs/SendDialog.h"

#include <QDialog>
#include <QHBoxLayout>
#include <QLineEdit>
#include <QPushButton>
#include <QScrollArea>
#include <QSplitter>
#include <QTest>
#include <QVBoxLayout>

namespace tabOrderUiTest {

/// The tab key goes through dialogs as one reads them.
class TabOrderUiTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void asLaidOutNotAsMade()
    {
        QDialog dialog;
        auto* last = new QPushButton(&dialog);
        auto* inner = new QPushButton(&dialog);
        auto* scrolled = new QLineEdit(&dialog);
        auto* right = new QPushButton(&dialog);
        auto* left = new QPushButton(&dialog);
        auto* row = new QHBoxLayout;
        row->addWidget(left);
        row->addWidget(right);
        auto* area = new QScrollArea(&dialog);
        area->setFocusPolicy(Qt::NoFocus);
        area->setWidgetResizable(true);
        area->setWidget(scrolled);
        auto* splitter = new QSplitter(&dialog);
        splitter->addWidget(inner);
        auto* layout = new QVBoxLayout(&dialog);
        layout->addLayout(row);
        layout->addWidget(area);
        layout->addWidget(splitter);
        layout->addWidget(last);
        dialog.show();
        QVERIFY(test::tabDisorder(dialog) != QString());
        ui::tabAsLaidOut(dialog);
        QCOMPARE(test::tabDisorder(dialog), QString());
        QCOMPARE(left->nextInFocusChain(), right);
    }

    void theExportDialogs()
    {
        test::WindowFixture fixture(test::headFirstSupine());
        ui::ExportDialog dialog(fixture.workspace, &fixture.window);
        dialog.show();
        QCOMPARE(test::tabDisorder(dialog), QString());
    }

    void codesAndTheirDetails()
    {
        ui::CodeDialog dialog(QStringLiteral("Liver"), {});
        dialog.askDetails({});
        dialog.show();
        QCOMPARE(test::tabDisorder(dialog), QString());
    }

    void sending()
    {
        ui::SendDialog dialog({QStringLiteral("mask.dcm")}, nullptr);
        dialog.show();
        QCOMPARE(test::tabDisorder(dialog), QString());
    }
};

BURIN_WINDOW_TEST(TabOrderUiTest)

} // namespace tabOrderUiTest

#include "TabOrderUiTest.moc"
