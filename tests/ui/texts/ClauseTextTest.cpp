// SPDX-License-Identifier: Apache-2.0
#include "ui/texts/ClauseText.h"

#include "tests/support/program/TestProgram.h"
#include "ui/base/ErrorText.h"

#include <QCoreApplication>
#include <QTest>
#include <QTranslator>

namespace clauseTextTest {

using core::Clause;
using core::ErrorCode;

/// Knows two clauses, by their context and English.
class TwoClauses : public QTranslator {
public:
    TwoClauses() { QCoreApplication::installTranslator(this); }
    ~TwoClauses() override { QCoreApplication::removeTranslator(this); }
    TwoClauses(const TwoClauses&) = delete;
    TwoClauses& operator=(const TwoClauses&) = delete;

    [[nodiscard]] QString translate(
        const char* context, const char* text, const char*, int) const override
    {
        if (qstrcmp(context, "core::Clause") != 0)
            return {};
        if (qstrcmp(text, "row %1: %2") == 0)
            return QStringLiteral("%2 (Zeile %1)");
        if (qstrcmp(text, "it holds %1 volumes") == 0)
            return QStringLiteral("sie enthält %1 Volumina");
        return {};
    }
    [[nodiscard]] bool isEmpty() const override { return false; }
};

/// Reasons of errors in the language of the user.
class ClauseTextTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void withoutTranslatorItIsTheEnglish()
    {
        const Clause clause = Clause::saying("row %1: %2", 3, QStringLiteral("a %1"));
        QCOMPARE(ui::clauseText(clause), clause.english());
    }

    void clausesAndTheirArgumentsAreTranslated()
    {
        const TwoClauses translator;
        const Clause known = Clause::saying("it holds %1 volumes", 2);
        QCOMPARE(ui::clauseText(known), QStringLiteral("sie enthält 2 Volumina"));
        QCOMPARE(ui::clauseText(Clause::saying("row %1: %2", 3, known)),
            QStringLiteral("sie enthält 2 Volumina (Zeile 3)"));
        QCOMPARE(ui::clauseText(Clause::saying("row %1: %2", 3, QStringLiteral("50%1 %2"))),
            QStringLiteral("50%1 %2 (Zeile 3)"));
    }

    void othersStayInEnglish()
    {
        const TwoClauses translator;
        QCOMPARE(ui::clauseText(Clause::saying("frame %1 has no position", 4)),
            QStringLiteral("frame 4 has no position"));
        QCOMPARE(ui::clauseText(QStringLiteral("it holds %1 volumes")),
            QStringLiteral("it holds %1 volumes"));
    }

    void errorsSayThem()
    {
        const TwoClauses translator;
        const core::Error error{ErrorCode::FileUnreadable,
            {QStringLiteral("/a/%2.nii"), Clause::saying("it holds %1 volumes", 2)}};
        QCOMPARE(ui::errorText(error),
            QStringLiteral("/a/%2.nii: cannot be read: sie enthält 2 Volumina"));
        QCOMPARE(error.arguments.value(1).english(), QStringLiteral("it holds 2 volumes"));
    }
};

BURIN_TEST(ClauseTextTest)

} // namespace clauseTextTest

#include "ClauseTextTest.moc"
