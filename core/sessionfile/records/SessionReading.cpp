// SPDX-License-Identifier: Apache-2.0
#include "core/sessionfile/records/SessionReading.h"

#include "core/sessionfile/database/SessionDatabase.h"
#include "core/sessionfile/records/RowText.h"
#include "core/titles/TitleJson.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QSqlQuery>

#include <algorithm>
#include <limits>
#include <utility>

namespace core {

namespace {

void takeState(const QString& key, const QString& value, SessionContents& contents)
{
    if (key == QLatin1String("position")) {
        bool isNumber = false;
        const RowId position = value.toLongLong(&isNumber);
        contents.position = isNumber ? position : -1;
    }
    if (key == QLatin1String("hiddenSegments")) {
        const QJsonArray labels = QJsonDocument::fromJson(value.toUtf8()).array();
        for (const QJsonValue& label : labels)
            contents.hiddenSegments.push_back(label.toInt());
    }
    if (key == QLatin1String("display"))
        contents.display = QJsonDocument::fromJson(value.toUtf8()).object();
}

} // namespace

bool holdsImages(SessionDatabase& database)
{
    bool any = false;
    database.query(QStringLiteral("SELECT images IS NOT NULL FROM source"), {},
        [&any](const QSqlQuery& answer) {
            any = answer.value(0).toBool();
            return true;
        });
    return any;
}

SessionReading::SessionReading(SessionDatabase& database, QString path)
    : m_database(database)
    , m_path(std::move(path))
{
}

Result<SessionContents> SessionReading::read()
{
    SessionContents contents;
    Result<SessionSource> source = readSource();
    if (!source)
        return tl::unexpected(source.error());
    contents.source = *std::move(source);
    readRows(contents);
    readDeltaSizes(contents);
    contents.chainEnd = m_chains.back();
    readState(contents);
    readKeyframes(contents);
    readTitles(contents);
    contents.holdsImages = holdsImages(m_database);
    const SessionLoss& loss = m_database.loss();
    contents.cutOff = !loss.cutOff.isEmpty() ? loss.cutOff
        : !loss.structure.isEmpty()          ? loss.structure
                                             : loss.foreign;
    contents.leftOpen = loss.leftOpen;
    contents.leftBeside = loss.leftBeside;
    return contents;
}

Result<SessionSource> SessionReading::readSource()
{
    QString json;
    const bool read = m_database.query(
        QStringLiteral("SELECT json FROM source"), {}, [&json](const QSqlQuery& answer) {
            json = answer.value(0).toString();
            return true;
        });
    if (const std::optional<Error> why = read ? std::nullopt : m_database.failureOutside())
        return tl::unexpected(*why);
    std::optional<SessionSource> source = SessionSource::fromJson(parsed(json));
    if (!read || !source) {
        const SessionLoss& loss = m_database.loss();
        return failure(ErrorCode::SessionDamaged, m_path,
            !loss.cutOff.isEmpty()         ? loss.cutOff
                : !loss.leftOpen.isEmpty() ? loss.leftOpen
                                           : Clause::saying("it does not say what it was made on"));
    }
    m_chains = {firstChain(json)};
    return *std::move(source);
}

void SessionReading::readRows(SessionContents& contents)
{
    std::vector<HistoryRow>& rows = contents.rows;
    Clause problem;
    const bool read = m_database.query(
        QStringLiteral("SELECT id, parent, iif(length(name) > 1000000, NULL, name), edit,"
                       " statistics, growthGeneration, chain, stateHash, deltaSha256, seal, at,"
                       " author, program FROM row ORDER BY id"),
        {}, [this, &rows, &problem](const QSqlQuery& answer) {
            tl::expected<HistoryRow, Clause> row = readRow(answer, RowId(rows.size()) + 1);
            if (!row) {
                problem = row.error();
                return false;
            }
            rows.push_back(*std::move(row));
            return true;
        });
    if (!read)
        problem = m_database.reason();
    // What is cut off in the middle of a page reads as zeros.
    if (const Clause& cutOff = m_database.loss().cutOff; !problem.isEmpty() && !cutOff.isEmpty())
        problem = cutOff;
    if (!problem.isEmpty())
        contents.damage = damageAt(RowId(rows.size()) + 1, problem);
}

void SessionReading::readDeltaSizes(SessionContents& contents)
{
    m_deltasReadable =
        m_database.query(QStringLiteral("SELECT row, SUM(LENGTH(bytes)) FROM delta GROUP BY row"),
            {}, [&contents](const QSqlQuery& answer) {
                const RowId row = answer.value(0).toLongLong();
                if (row > 0 && row <= RowId(contents.rows.size()))
                    contents.rows[std::size_t(row - 1)].deltaBytes =
                        std::size_t(answer.value(1).toLongLong());
                return true;
            });
}

tl::expected<HistoryRow, Clause> SessionReading::readRow(const QSqlQuery& answer, RowId expectedId)
{
    const RowText text{.id = answer.value(0).toLongLong(),
        .parent = answer.value(1).toLongLong(),
        .name = answer.value(2).toString(),
        .edit = answer.value(3).toString(),
        .statistics = answer.value(4).toString(),
        .growthGeneration = answer.value(5).toLongLong(),
        .at = answer.value(10).toString(),
        .author = answer.value(11).toString(),
        .program = answer.value(12).toString()};
    if (text.id != expectedId || text.parent < 0 || text.parent >= text.id)
        return tl::unexpected(Clause::saying("it is missing or out of order"));
    // The chain does not cover what stands beside a missing time.
    const bool unbound = text.at.isEmpty() && !(text.author + text.program).isEmpty();
    const QString chain = text.chain(m_chains.back());
    if (unbound || chain != answer.value(6).toString())
        return tl::unexpected(Clause::saying("it was changed after it was written"));

    Result<HistoryRow> row = text.row();
    if (!row)
        return tl::unexpected(Clause::saying(
            "its edit is not known here: %1", row.error().arguments.join(QStringLiteral(", "))));
    if (namesNoEarlierRow(text.id, row->edit))
        return tl::unexpected(Clause::saying("it names a step that does not lie before it"));
    if (!answer.value(9).isNull()) {
        const QString stateHash = answer.value(7).toString();
        if (answer.value(9).toString() != seal(chain, stateHash, answer.value(8).toString()))
            return tl::unexpected(Clause::saying("its hash was changed after it was written"));
        row->stateHash = stateHash.toLatin1();
    }
    m_chains.push_back(chain);
    return *std::move(row);
}

void SessionReading::readState(SessionContents& contents)
{
    bool told = false;
    QString end;
    const bool placed = m_database.query(QStringLiteral("SELECT key, value FROM state"), {},
        [&contents, &told, &end](const QSqlQuery& answer) {
            const QString key = answer.value(0).toString();
            told |= key == QLatin1String("position");
            if (key == sessionEndKey)
                end = answer.value(1).toString();
            takeState(key, answer.value(1).toString(), contents);
            return true;
        });
    const Clause& cutOff = m_database.loss().cutOff;
    if (!placed || (!cutOff.isEmpty() && !told && !contents.rows.empty()))
        contents.position = -1;
    const bool read = placed
        && m_database.query(QStringLiteral("SELECT parent, child FROM visited"), {},
            [&contents](const QSqlQuery& answer) {
                contents.visited.emplace_back(
                    answer.value(0).toLongLong(), answer.value(1).toLongLong());
                return true;
            });
    const Clause endless = checkEnd(end, contents);
    const RowId position = contents.position;
    const std::size_t steps = contents.visited.size();
    contents.cut(contents.damage.value_or(SessionDamage{}));
    if (contents.damage->row != 0)
        return;
    // No row is lost, so both must have been sound.
    if (!read)
        contents.damage->reason = m_database.reason();
    else if (contents.position != position || contents.visited.size() != steps)
        contents.damage->reason =
            cutOff.isEmpty() ? Clause::saying("its position is no row") : cutOff;
    else if (!endless.isEmpty())
        contents.damage->reason = endless;
    else
        contents.damage.reset();
}

Clause SessionReading::checkEnd(const QString& end, SessionContents& contents)
{
    // Sessions of builds before have no such line, and where they went on rows may lie behind it.
    if (end.isEmpty())
        return {};
    bool isNumber = false;
    const RowId last = end.section(QLatin1Char(' '), 0, 0).toLongLong(&isNumber);
    if (!isNumber || last < 1)
        return Clause::saying("how many rows it has is not said");
    const auto count = RowId(contents.rows.size());
    std::optional<SessionDamage>& damage = contents.damage;
    if (damage)
        damage->after = std::max<std::int64_t>(damage->after, last - damage->row);
    else if (last > count)
        damage = {.row = count + 1,
            .name = {},
            .after = last - count - 1,
            .reason = Clause::saying("it is missing; the session had %1 rows", last)};
    else if (m_chains[std::size_t(last)] != end.section(QLatin1Char(' '), 1))
        damage = damageAt(last, Clause::saying("it is not the row that stood there last"));
    return {};
}

SessionDamage SessionReading::damageAt(RowId row, const Clause& reason)
{
    SessionDamage damage{.row = row, .name = {}, .after = -1, .reason = reason};
    m_database.query(QStringLiteral("SELECT substr(name, 1, 200) FROM row WHERE id=?"),
        {qint64(row)}, [&damage](const QSqlQuery& answer) {
            damage.name = answer.value(0).toString();
            return true;
        });
    m_database.query(QStringLiteral("SELECT COUNT(*) FROM row WHERE id>?"), {qint64(row)},
        [&damage](const QSqlQuery& answer) {
            damage.after = answer.value(0).toLongLong();
            return true;
        });
    return damage;
}

/// Pictures prove nothing: those that cannot be read are left out.
void SessionReading::readKeyframes(SessionContents& contents)
{
    m_database.query(QStringLiteral("SELECT row, at FROM keyframe ORDER BY row"), {},
        [&contents](const QSqlQuery& answer) {
            const RowId row = answer.value(0).toLongLong();
            const QString at = answer.value(1).toString();
            if (row >= 0 && row <= RowId(contents.rows.size()))
                contents.keyframes.push_back({.row = row,
                    .at = QDateTime::fromString(at, Qt::ISODateWithMs).toUTC(),
                    .png = {}});
            return true;
        });
}

/// Names are what counts: of a row whose title is not there, or not its own, the name is shown.
void SessionReading::readTitles(SessionContents& contents)
{
    m_database.query(QStringLiteral("SELECT row, iif(length(json) > %1, NULL, json) FROM title "
                                    "ORDER BY row")
                         .arg(TitleLimits::letters),
        {}, [&contents, last = std::numeric_limits<RowId>::min()](const QSqlQuery& answer) mutable {
            const RowId id = answer.value(0).toLongLong();
            // A table that leads back into itself has no end.
            if (id <= last)
                return false;
            last = id;
            if (id > 0 && id <= RowId(contents.rows.size())) {
                HistoryRow& row = contents.rows[std::size_t(id - 1)];
                row.title = titleFromText(answer.value(1).toString(), row.name);
            }
            return true;
        });
}

} // namespace core
