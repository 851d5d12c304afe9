// SPDX-License-Identifier: Apache-2.0
#include "core/base/words/Clause.h"
#include "core/base/Result.h"
#include "tests/support/program/TestProgram.h"

#include <QTest>

#include <cstdint>

namespace clauseTest {

using core::Clause;
using core::Clauses;
using core::Error;
using core::ErrorCode;

/// A reason as a form with arguments, and its English.
class ClauseTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void numbersAndTextsStandInTheForm()
    {
        const Clause clause = Clause::saying("piece %1 of '%2' weighs %3 g, %4 of them", 3,
            QLatin1String("a.nii"), 0.25, std::uint64_t(1) << 40);
        QCOMPARE(clause.english(),
            QStringLiteral("piece 3 of 'a.nii' weighs 0.25 g, 1099511627776 of "
                           "them"));
        QCOMPARE(clause.form(), "piece %1 of '%2' weighs %3 g, %4 of them");
        QCOMPARE(clause.arguments().size(), std::size_t(4));
        QVERIFY(clause.arguments()[1].form() == nullptr);
        // As QString::arg() writes a number.
        QCOMPARE(Clause::saying("%1", 1.0 / 3.0).english(), QStringLiteral("%1").arg(1.0 / 3.0));
        QCOMPARE(Clause::saying("%1", std::uint8_t(7)).english(), QStringLiteral("7"));
    }

    void clausesStandInClauses()
    {
        const Clause inner =
            Clause::saying("its voxels in %1 are damaged", QStringLiteral("a.raw"));
        const Clause outer = Clause::saying("row %1: %2", 9, inner);
        QCOMPARE(outer.english(), QStringLiteral("row 9: its voxels in a.raw are damaged"));
        QCOMPARE(outer.arguments()[1].form(), "its voxels in %1 are damaged");
        QCOMPARE(outer.arguments()[1].arguments()[0].english(), QStringLiteral("a.raw"));
    }

    void whatLooksLikeAPlaceInAnArgumentStays()
    {
        const Clause clause = Clause::saying(
            "%1 and %2, 100%", QStringLiteral("50%2 off %1"), Clause::saying("%1", "%2"));
        QCOMPARE(clause.english(), QStringLiteral("50%2 off %1 and %2, 100%"));
    }

    void plainTextHasNoForm()
    {
        const Clause plain = QStringLiteral("/home/%1/a.dcm");
        QCOMPARE(plain.english(), QStringLiteral("/home/%1/a.dcm"));
        QVERIFY(plain.form() == nullptr);
        QVERIFY(plain.arguments().empty());
        QVERIFY(Clause().isEmpty());
        // As it comes out of a pipe.
        const QString text = Clause::saying("damaged pixel data");
        QVERIFY(Clause(text).form() == nullptr);
    }

    void replacingKeepsTheForm()
    {
        const QString hidden = QStringLiteral("/tmp/.x1"), target = QStringLiteral("/tmp/a.nii");
        const Clause clause =
            Clause::saying("%1: %2", 1, Clause::saying("the folder %1 is full", hidden));
        const Clause replaced = clause.replaced(hidden, target);
        QCOMPARE(replaced.english(), QStringLiteral("1: the folder /tmp/a.nii is full"));
        QCOMPARE(replaced.arguments()[1].form(), "the folder %1 is full");
        QCOMPARE(Clause(hidden + u'~').replaced(hidden, target).english(), target + u'~');
    }

    void failuresTakeClausesAndTexts()
    {
        const Error error = core::failure(ErrorCode::FileUnreadable, QStringLiteral("a.nii"),
            Clause::saying("it holds %1 volumes", 2))
                                .value();
        QCOMPARE(error.arguments.size(), 2);
        QVERIFY(error.arguments[0].form() == nullptr);
        QCOMPARE(error.arguments.value(1).form(), "it holds %1 volumes");
        QCOMPARE(error.arguments.value(1), QStringLiteral("it holds 2 volumes"));
        QVERIFY(error.arguments.value(2).isEmpty());
        QCOMPARE(error.arguments.join(u'|'), QStringLiteral("a.nii|it holds 2 volumes"));
    }

    void argumentsChangeAsWholes()
    {
        Clauses arguments{QStringLiteral("/tmp/.x1"), Clause::saying("%1 is full", "/tmp/.x1")};
        arguments.exchange(QStringLiteral("/tmp/.x1"), QStringLiteral("b"));
        QVERIFY(
            arguments == (QStringList{QStringLiteral("b"), QStringLiteral("/tmp/.x1 is full")}));
        arguments.replace(QStringLiteral("/tmp/.x1"), QStringLiteral("c"));
        QCOMPARE(arguments[1], QStringLiteral("c is full"));
        QCOMPARE(arguments[1].form(), "%1 is full");
        arguments.set(3, QStringLiteral("d"));
        QCOMPARE(arguments.size(), 4);
        QCOMPARE(arguments.mid(2).join(u'|'), QStringLiteral("|d"));
        arguments.prepend(QStringLiteral("a"));
        QCOMPARE(arguments.front(), QStringLiteral("a"));
    }
};

BURIN_TEST(ClauseTest)

} // namespace clauseTest

#include "ClauseTest.moc"
