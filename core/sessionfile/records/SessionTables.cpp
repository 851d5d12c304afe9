// SPDX-License-Identifier: Apache-2.0
#include "core/sessionfile/records/SessionTables.h"

#include "core/sessionfile/records/SessionReading.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QSqlQuery>

#include <utility>

namespace core {

namespace {

QVariant sqlId(RowId id)
{
    return qint64(id);
}

/// Text that is there though it may be empty; a row without a time has none, which is NULL.
QVariant sqlText(const QString& text, bool isThere)
{
    if (!isThere)
        return QVariant(QMetaType(QMetaType::QString));
    return text.isNull() ? QStringLiteral("") : text;
}

} // namespace

SessionTables::SessionTables(QString path)
    : m_path(std::move(path))
{
}

Result<void> SessionTables::create(const SessionSource& source)
{
    const QString json = compact(source.toJson());
    const auto begin = [&json](SessionDatabase& database) {
        return database.run(QStringLiteral("INSERT INTO source (id, json) VALUES (1, ?)"), {json});
    };
    Result<std::unique_ptr<SessionDatabase>> made = SessionDatabase::create(m_path, begin);
    if (!made)
        return tl::unexpected(made.error());
    m_database = *std::move(made);
    m_chains = {firstChain(json)};
    return {};
}

Result<SessionContents> SessionTables::open(SessionAccess access)
{
    Result<std::unique_ptr<SessionDatabase>> opened = access == SessionAccess::PrivateCopy
        ? SessionDatabase::openCopy(m_path)
        : SessionDatabase::open(m_path, access != SessionAccess::ReadWrite);
    if (!opened)
        return tl::unexpected(opened.error());
    m_database = *std::move(opened);
    const bool isLookedThrough =
        access == SessionAccess::ReadWrite || access == SessionAccess::PrivateCopy;
    if (!isLookedThrough) {
        if (const Result<void> looked = m_database->checkStructure(); !looked)
            return tl::unexpected(looked.error());
    }
    SessionReading reading(*m_database, m_path);
    Result<SessionContents> contents = reading.read();
    m_chains = reading.chains();
    if (access == SessionAccess::SoundPart || !contents)
        return contents;
    if (contents->damage)
        return tl::unexpected(contents->damage->error(m_path));
    if (!reading.areDeltasReadable())
        return failure(ErrorCode::SessionDamaged, m_path,
            Clause::saying("what its rows changed cannot be read"));
    return contents;
}

Result<SessionContents> SessionTables::readAgain()
{
    return SessionReading(*m_database, m_path).read();
}

Result<void> SessionTables::copyInto(const QString& path)
{
    if (m_database->copyInto(path))
        return {};
    return failure(ErrorCode::FileUnwritable, path, m_database->reason());
}

Result<void> SessionTables::copyHistoryInto(const QString& path)
{
    if (m_database->copyHistoryInto(path))
        return {};
    return failure(ErrorCode::FileUnwritable, path, m_database->reason());
}

bool SessionTables::holdsImages()
{
    return core::holdsImages(*m_database);
}

// --- Writing -------------------------------------------------------------------------------------

Result<void> SessionTables::addRow(const RowText& row)
{
    const QString chain = row.chain(m_chains.back());
    const bool told = !row.at.isEmpty();
    const Result<void> stands = write([&] {
        return m_database->run(QStringLiteral("INSERT INTO row (id, parent, name, edit, statistics,"
                                              " growthGeneration, at, author, program, chain)"
                                              " VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?)"),
                   {sqlId(row.id), sqlId(row.parent), row.name, row.edit, row.statistics,
                       row.growthGeneration, sqlText(row.at, told), sqlText(row.author, told),
                       sqlText(row.program, told), chain})
            && writeTitle(row) && writePosition(row.id)
            && writeState(sessionEndKey, QStringLiteral("%1 %2").arg(row.id).arg(chain));
    });
    if (stands)
        m_chains.push_back(chain);
    return stands;
}

Result<void> SessionTables::completeRow(
    RowId row, const QByteArray& stateHash, const BrickDelta& delta)
{
    return write([&] {
        for (std::size_t piece = 0; piece < delta.pieces.size(); ++piece) {
            if (!m_database->run(QStringLiteral("INSERT INTO delta VALUES (?, ?, ?)"),
                    {sqlId(row), int(piece), delta.pieces[piece]}))
                return false;
        }
        const QString hash = QString::fromLatin1(stateHash);
        const QString deltaHash = sha256(delta);
        return m_database->run(
            QStringLiteral("UPDATE row SET stateHash=?, deltaSha256=?, seal=? WHERE id=?"),
            {hash, deltaHash, seal(m_chains[std::size_t(row)], hash, deltaHash), sqlId(row)});
    });
}

Result<void> SessionTables::setPosition(RowId position)
{
    return write([&] { return writePosition(position); });
}

Result<void> SessionTables::setHiddenSegments(const std::vector<int>& labels)
{
    QJsonArray list;
    for (const int label : labels)
        list.append(label);
    const QString text = QString::fromUtf8(QJsonDocument(list).toJson(QJsonDocument::Compact));
    return write([&] { return writeState(QStringLiteral("hiddenSegments"), text); });
}

Result<void> SessionTables::addKeyframe(const Keyframe& keyframe)
{
    return write([&] {
        return m_database->run(QStringLiteral("INSERT OR REPLACE INTO keyframe VALUES (?, ?, ?)"),
            {sqlId(keyframe.row), sqlText(keyframe.at.toUTC().toString(Qt::ISODateWithMs), true),
                keyframe.png});
    });
}

Result<void> SessionTables::setDisplay(const QJsonObject& display)
{
    const QString text = QString::fromUtf8(QJsonDocument(display).toJson(QJsonDocument::Compact));
    return write([&] { return writeState(QStringLiteral("display"), text); });
}

Result<void> SessionTables::write(const std::function<bool()>& work)
{
    if (m_database->transaction(work))
        return {};
    return failure(ErrorCode::FileUnwritable, m_path, m_database->reason());
}

bool SessionTables::writeTitle(const RowText& row)
{
    return row.title.isEmpty()
        || (m_database->makeRoomForTitles()
            && m_database->run(QStringLiteral("INSERT OR REPLACE INTO title VALUES (?, ?)"),
                {sqlId(row.id), row.title}));
}

bool SessionTables::writePosition(RowId position)
{
    return writeState(QStringLiteral("position"), QString::number(position))
        && m_database->run(
            QStringLiteral("INSERT OR REPLACE INTO visited SELECT parent, id FROM row WHERE id=?"),
            {sqlId(position)});
}

bool SessionTables::writeState(const QString& key, const QString& value)
{
    return m_database->run(
        QStringLiteral("INSERT OR REPLACE INTO state VALUES (?, ?)"), {key, value});
}

// --- Reading -------------------------------------------------------------------------------------

Result<BrickDelta> SessionTables::readDelta(RowId row)
{
    BrickDelta delta;
    QString expected;
    const bool read =
        m_database->query(QStringLiteral("SELECT deltaSha256 FROM row WHERE id=?"), {sqlId(row)},
            [&expected](const QSqlQuery& answer) {
                expected = answer.value(0).toString();
                return true;
            })
        && m_database->query(QStringLiteral("SELECT bytes FROM delta WHERE row=? ORDER BY piece"),
            {sqlId(row)}, [&delta](const QSqlQuery& answer) {
                delta.pieces.push_back(answer.value(0).toByteArray());
                return true;
            });
    if (!read)
        return damaged(row, m_database->reason());
    if (sha256(delta) != expected)
        return damaged(row, Clause::saying("its difference was changed"));
    return delta;
}

QByteArray SessionTables::readKeyframe(RowId row)
{
    QByteArray png;
    m_database->query(QStringLiteral("SELECT png FROM keyframe WHERE row=?"), {sqlId(row)},
        [&png](const QSqlQuery& answer) {
            png = answer.value(0).toByteArray();
            return true;
        });
    return png;
}

tl::unexpected<Error> SessionTables::damaged(RowId row, const Clause& reason) const
{
    return failure(ErrorCode::SessionDamaged, m_path, Clause::saying("row %1: %2", row, reason));
}

} // namespace core
