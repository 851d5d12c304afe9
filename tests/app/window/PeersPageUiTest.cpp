// SPDX-License-Identifier: Apache-2.0
#include "tests/support/fixtures/ApplicationFixture.h"
#include "tests/support/program/TestProgram.h"
#include "ui/base/Actions.h"
#include "ui/input/Tool.h"

#include <QAction>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QImage>
#include <QMenu>
#include <QMenuBar>
#include <QRegularExpression>
#include <QTest>

#include <algorithm>
#include <array>
#include <vector>

namespace peersPageUiTest {

namespace {

QString pathOf(const char* page)
{
    return QStringLiteral(BURIN_SOURCE_DIR "/resources/help/%1").arg(QLatin1String(page));
}

QString textOf(const char* page)
{
    QFile file(pathOf(page));
    return file.open(QIODevice::ReadOnly) ? QString::fromUtf8(file.readAll()) : QString();
}

/// What a menu shows: without the marks of letters.
QString shown(QString text)
{
    text.replace(QLatin1String("&&"), QString(QChar(0)));
    text.remove(QLatin1Char('&'));
    return text.replace(QChar(0), QLatin1Char('&'));
}

/// "Grow > Paint" from the menu bar on; null if there is no such entry.
const QAction* entryAt(const QMenuBar& bar, const QString& path)
{
    QList<QAction*> entries = bar.actions();
    const QAction* found = nullptr;
    for (const QString& name : path.split(QStringLiteral(" > "))) {
        const auto at = std::find_if(entries.begin(), entries.end(),
            [&name](const QAction* each) { return shown(each->text()) == name; });
        if (at == entries.end())
            return nullptr;
        found = *at;
        const QMenu* menu = found->menu();
        entries = menu ? menu->actions() : QList<QAction*>();
    }
    return found;
}

bool hasKey(const QAction& action, const QString& key)
{
    return action.shortcuts().contains(QKeySequence(key, QKeySequence::PortableText));
}

/// What a page says that the window has not: entries in bold, the key in brackets after one, and
/// keys that stand alone.
QStringList untrue(const QString& page, const test::ApplicationFixture& fixture)
{
    const auto* bar = fixture.window().findChild<QMenuBar*>();
    const std::vector<QAction*> all = fixture.window().actionTable().all();
    QStringList wrong;
    static const QRegularExpression entry(
        QStringLiteral("\\*\\*([^*\\n]+ > [^*\\n]+)\\*\\*(?: \\(`([^`\\n]+)`\\))?"));
    for (auto each = entry.globalMatch(page); each.hasNext();) {
        const QRegularExpressionMatch match = each.next();
        const QAction* action = entryAt(*bar, match.captured(1));
        if (!action) {
            wrong += match.captured(1);
            continue;
        }
        // The window makes submenus of its own; all else is in the table.
        if (!action->menu() && std::find(all.begin(), all.end(), action) == all.end())
            wrong += QStringLiteral("%1 (not in the table)").arg(match.captured(1));
        if (!match.captured(2).isEmpty() && !hasKey(*action, match.captured(2)))
            wrong += QStringLiteral("%1 (%2)").arg(match.captured(1), match.captured(2));
    }
    static const QRegularExpression code(QStringLiteral("`([^`\\n]+)`"));
    for (auto each = code.globalMatch(page); each.hasNext();) {
        const QString key = each.next().captured(1);
        const bool known = key.startsWith(QLatin1String("burin "))
            || std::any_of(all.begin(), all.end(),
                [&key](const QAction* action) { return hasKey(*action, key); });
        if (!known)
            wrong += key;
    }
    return wrong;
}

/// The cells of the row that begins with this one; empty: there is none, or more than one.
QStringList rowOf(const QString& page, const QString& name)
{
    QStringList found;
    for (const QString& line : page.split(QLatin1Char('\n'))) {
        if (!line.startsWith(QStringLiteral("| %1 |").arg(name)))
            continue;
        if (!found.isEmpty())
            return {};
        for (const QString& cell : line.split(QLatin1Char('|')).mid(1, 3))
            found += cell.trimmed();
    }
    return found;
}

} // namespace

/// The pages for users of other programs: what they name is in the window, no row of the peers'
/// tables is left without an answer, and no task takes more steps than elsewhere.
class PeersPageUiTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void menusAndKeysAreThoseOfTheWindow_data()
    {
        QTest::addColumn<QString>("page");
        QTest::addColumn<int>("entries");
        QTest::newRow("peers") << textOf("peers.md") << 80;
        QTest::newRow("tasks") << textOf("tasks.md") << 10;
    }
    void menusAndKeysAreThoseOfTheWindow()
    {
        QFETCH(QString, page);
        QFETCH(int, entries);
        const test::ApplicationFixture fixture;
        QVERIFY2(page.count(QLatin1String(" > ")) >= entries, "the page names next to nothing");
        const QStringList wrong = untrue(page, fixture);
        QVERIFY2(wrong.isEmpty(), qPrintable(wrong.join(QLatin1Char('\n'))));
    }

    void whatIsUntrueIsFound()
    {
        const test::ApplicationFixture fixture;
        QCOMPARE(untrue(QStringLiteral("**Grow > Paint** (`B`), **Grow > Wish**, **Grow > Paint** "
                                       "(`T`), `Ctrl+Alt+Shift+F5`, **not an entry**, `burin run`"),
                     fixture),
            (QStringList{QStringLiteral("Grow > Wish"), QStringLiteral("Grow > Paint (T)"),
                QStringLiteral("Ctrl+Alt+Shift+F5")}));
    }

    void noRowIsUnanswered_data()
    {
        QTest::addColumn<QString>("letter");
        QTest::addColumn<int>("rows");
        QTest::newRow("tools") << QStringLiteral("T") << 25;
        QTest::newRow("viewers") << QStringLiteral("R") << 32;
        QTest::newRow("sculpting") << QStringLiteral("A") << 16;
        QTest::newRow("refining") << QStringLiteral("B") << 13;
    }
    void noRowIsUnanswered()
    {
        QFETCH(QString, letter);
        QFETCH(int, rows);
        const QString page = textOf("peers.md");
        for (int row = 1; row <= rows; ++row) {
            const QString name = letter + QString::number(row);
            const QStringList cells = rowOf(page, name);
            QVERIFY2(
                cells.size() == 3 && !cells[1].isEmpty() && !cells[2].isEmpty(), qPrintable(name));
        }
        QVERIFY(rowOf(page, letter + QString::number(rows + 1)).isEmpty());
    }

    /// Steps are numbered from 1 on; the last row says how many each column has.
    void noTaskIsLonger()
    {
        const QStringList tasks = textOf("tasks.md").split(QStringLiteral("\n## ")).mid(1);
        QCOMPARE(tasks.size(), 4);
        for (const QString& task : tasks) {
            std::array<int, 2> counted{};
            int row = 1;
            QStringList cells = rowOf(task, QString::number(row));
            while (cells.size() == 3) {
                for (std::size_t column = 0; column < 2; ++column)
                    counted[column] += cells[qsizetype(column) + 1].isEmpty() ? 0 : 1;
                cells = rowOf(task, QString::number(++row));
            }
            const QStringList together = rowOf(task, QStringLiteral("together"));
            QCOMPARE(together,
                (QStringList{QStringLiteral("together"), QString::number(counted[0]),
                    QString::number(counted[1])}));
            QVERIFY2(counted[1] > 0 && counted[1] <= counted[0],
                qPrintable(task.section(QLatin1Char('\n'), 0, 0)));
        }
    }

    /// Each tool is shown in use: the caption of a picture in the manual names it.
    void everyToolHasAPicture()
    {
        static const QRegularExpression picture(
            QStringLiteral("!\\[([^\\]]+)\\]\\(([^)]+[.]png)\\)"));
        QStringList captions;
        const QDir help(QFileInfo(pathOf("peers.md")).dir());
        for (const QString& page : help.entryList({QStringLiteral("*.md")}, QDir::Files)) {
            const QString text = textOf(page.toUtf8().constData());
            for (auto each = picture.globalMatch(text); each.hasNext();) {
                const QRegularExpressionMatch match = each.next();
                QVERIFY2(!QImage(help.filePath(match.captured(2))).isNull(),
                    qPrintable(match.captured(2)));
                captions += match.captured(1);
            }
        }
        const test::ApplicationFixture fixture;
        const QList<ui::Tool*> tools = fixture.window().findChildren<ui::Tool*>();
        QVERIFY(tools.size() > 20);
        QStringList unseen;
        for (const ui::Tool* tool : tools) {
            const QRegularExpression word(
                QStringLiteral("\\b%1\\b").arg(QRegularExpression::escape(tool->longName())),
                QRegularExpression::CaseInsensitiveOption);
            QStringList own = captions;
            for (const ui::Tool* other : tools) {
                if (other != tool
                    && other->longName().contains(tool->longName(), Qt::CaseInsensitive))
                    own.replaceInStrings(other->longName(), QString(), Qt::CaseInsensitive);
            }
            if (own.filter(word).isEmpty())
                unseen += tool->longName();
        }
        QVERIFY2(unseen.isEmpty(), qPrintable(unseen.join(QStringLiteral(", "))));
    }

    void linksLeadToPages()
    {
        static const QRegularExpression link(QStringLiteral("\\]\\(([^)#]+)\\)"));
        int links = 0;
        for (const char* page : {"peers.md", "tasks.md"}) {
            const QString text = textOf(page);
            for (auto each = link.globalMatch(text); each.hasNext(); ++links) {
                const QString target = each.next().captured(1);
                QVERIFY2(
                    QFileInfo(QFileInfo(pathOf(page)).dir(), target).isFile(), qPrintable(target));
            }
        }
        QVERIFY(links >= 2);
    }
};

BURIN_WINDOW_TEST(PeersPageUiTest)

} // namespace peersPageUiTest

#include "PeersPageUiTest.moc"
