// SPDX-License-Identifier: Apache-2.0
#include "ui/texts/SessionTexts.h"

#include "tests/support/program/MarkingTranslator.h"
#include "tests/support/program/TestProgram.h"

#include <QTest>

/// What is said of a session file.
class SessionTextsTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void deidentified()
    {
        core::DeidentifiedSession session{
            .steps = 2, .method = QStringLiteral("PS3.15 basic profile; dates removed")};
        const QString names =
            QStringLiteral("Names of segments, sculpt layers and bookmarks stay as they are.");
        QCOMPARE(ui::deidentifiedTexts(session),
            (QStringList{
                QStringLiteral("A session of 2 steps without where its study was, UIDs, authors "
                               "and pictures; PS3.15 basic profile; dates removed. Every hash was "
                               "compared."),
                names}));
        session.steps = 1;
        session.imagesLeftOut = true;
        const QStringList one = ui::deidentifiedTexts(session);
        QVERIFY(one.front().startsWith(QStringLiteral("A session of 1 step without")));
        QCOMPARE(
            one.mid(1), (QStringList{QStringLiteral("The study's images were left out."), names}));
        const test::MarkingTranslator translator;
        for (const QString& sentence : ui::deidentifiedTexts(session))
            QVERIFY2(sentence.startsWith(u'<') && sentence.endsWith(u'>'), qPrintable(sentence));
    }
};

BURIN_TEST(SessionTextsTest)
#include "SessionTextsTest.moc"
