// SPDX-License-Identifier: Apache-2.0
#include "ui/texts/SessionTexts.h"

#include "tests/support/program/MarkingTranslator.h"
#include "tests/support/program/TestProgram.h"
#include "ui/base/ErrorText.h"

#include <QTest>

namespace sessionTextsTest {

/// What is said of a session file.
class SessionTextsTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void lostRows()
    {
        const QString reason = QStringLiteral("it is missing");
        const auto said = [&](core::RowId row, const char* name, std::int64_t after) {
            const core::SessionDamage damage{
                .row = row, .name = QString::fromUtf8(name), .after = after, .reason = reason};
            const core::Error error = damage.error(QStringLiteral("a.burin"));
            const QString text = ui::damageText(damage);
            return ui::damageText(error) == text
                    && ui::errorText(error)
                        == QStringLiteral("a.burin: the session is damaged: ") + text
                ? text
                : QStringLiteral("its error says '%1'").arg(ui::errorText(error));
        };
        QCOMPARE(said(0, "", 0), QStringLiteral("where it stood cannot be read: it is missing"));
        QCOMPARE(said(17, "Drill %1 5 mm", 5),
            QStringLiteral("row 17 'Drill %1 5 mm' and the 5 after it cannot be read: it is "
                           "missing"));
        QCOMPARE(said(17, "", 1),
            QStringLiteral("row 17 and the one after it cannot be read: it is missing"));
        QCOMPARE(said(17, "A", 0), QStringLiteral("row 17 'A' cannot be read: it is missing"));
        QCOMPARE(said(17, "A", -1),
            QStringLiteral("row 17 'A' and all after it cannot be read: it is missing"));
        // A name may be damaged itself.
        QCOMPARE(said(1,
                     "A\n\x01"
                     "B",
                     0),
            QStringLiteral("row 1 'A B' cannot be read: it is missing"));
        const QString text = said(1, QByteArray(100, 'x').constData(), 0);
        QVERIFY2(text.startsWith(QStringLiteral("row 1 '%1…' ").arg(QString(60, u'x'))),
            qPrintable(text));
        QCOMPARE(ui::errorText({core::ErrorCode::SessionDamaged,
                     {QStringLiteral("a.burin"), QStringLiteral("row 3: gone")}}),
            QStringLiteral("a.burin: the session is damaged: row 3: gone"));
        QCOMPARE(ui::errorText({core::ErrorCode::SessionDamaged, {QStringLiteral("a.burin")}}),
            QStringLiteral("a.burin: the session is damaged"));
        const test::MarkingTranslator translator;
        for (const core::RowId row : {0, 17}) {
            const QString marked = ui::damageText(core::SessionDamage{
                .row = row, .name = QStringLiteral("A"), .after = 5, .reason = reason});
            QVERIFY2(marked.startsWith(u'<') && marked.endsWith(u'>'), qPrintable(marked));
        }
    }

    void problems()
    {
        core::SessionContents contents;
        QCOMPARE(ui::problemTexts(contents), QStringList());
        const QString cutOff = QStringLiteral("the file is cut off: 1 of 2 bytes are there");
        contents.cutOff = cutOff;
        QCOMPARE(
            ui::problemTexts(contents), QStringList{cutOff + QStringLiteral("; no row is lost")});
        contents.redo = {{.row = 3, .name = QStringLiteral("A"), .reason = QStringLiteral("gone")}};
        contents.leftOpen = QStringLiteral("it was not closed");
        QCOMPARE(ui::problemTexts(contents),
            (QStringList{QStringLiteral("what row 3 'A' changed cannot be read (gone); it can be "
                                        "carried out again"),
                cutOff + QStringLiteral("; no row is lost"), contents.leftOpen}));
        contents.redo.push_back({.row = 5, .name = {}, .reason = {}});
        contents.damage = core::SessionDamage{.row = 7, .name = {}, .after = 0, .reason = cutOff};
        // How much is there is said once.
        QCOMPARE(ui::problemTexts(contents),
            (QStringList{QStringLiteral("row 7 cannot be read: ") + cutOff,
                QStringLiteral("what the rows 3, 5 changed cannot be read; they can be carried out "
                               "again"),
                contents.leftOpen}));
        contents.damage->reason = QStringLiteral("gone");
        QCOMPARE(ui::problemTexts(contents).value(2), cutOff);
    }

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

} // namespace sessionTextsTest

#include "SessionTextsTest.moc"
