// SPDX-License-Identifier: Apache-2.0
#include "core/sessionfile/HistoryListing.h"

#include "core/edits/EditAsGiven.h"
#include "core/edits/EditJson.h"
#include "core/edits/EditNames.h"
#include "core/edits/document/DocumentEdits.h"
#include "core/sessionfile/records/StateHash.h"

#include <QJsonArray>
#include <QJsonDocument>

#include <algorithm>

namespace core {

namespace {

History historyOf(const SessionContents& contents)
{
    return History::restored(contents.rows, contents.visited, contents.position);
}

QJsonValue hashValue(const QByteArray& hash)
{
    return hash.isEmpty() ? QJsonValue() : QJsonValue(QString::fromLatin1(hash));
}

/// Rows that older versions wrote do not say who made them, and when.
QJsonValue told(const HistoryRow& row, const QString& text)
{
    return row.origin.at.isValid() ? QJsonValue(text) : QJsonValue();
}

/// The state that every session begins with.
QByteArray hashOfBeginning()
{
    const QJsonObject document = initialDocument({}).hashedState();
    return StateHash().root(QJsonDocument(document).toJson(QJsonDocument::Compact));
}

} // namespace

std::vector<HistoryBranch> branchesOf(const History& history)
{
    std::vector<bool> hasChild(history.rows().size() + 1, false);
    for (const HistoryRow& row : history.rows())
        hasChild[std::size_t(row.parent)] = true;
    const std::vector<RowId> line = history.line();
    const std::vector<bool> onLine = [&] {
        std::vector<bool> flags(history.rows().size() + 1, false);
        for (const RowId id : line)
            flags[std::size_t(id)] = true;
        return flags;
    }();

    std::vector<HistoryBranch> branches;
    if (!line.empty())
        branches.push_back({.tip = line.back(), .forksAt = 0, .rows = line, .current = true});
    for (const HistoryRow& row : history.rows()) {
        if (hasChild[std::size_t(row.id)] || onLine[std::size_t(row.id)])
            continue;
        HistoryBranch branch{.tip = row.id, .forksAt = 0, .rows = {}, .current = false};
        RowId at = row.id;
        for (; at != 0 && !onLine[std::size_t(at)]; at = history.row(at).parent)
            branch.rows.push_back(at);
        branch.forksAt = at;
        std::reverse(branch.rows.begin(), branch.rows.end());
        branches.push_back(std::move(branch));
    }
    return branches;
}

QJsonObject historyListing(const SessionContents& contents, const QStringList& problems)
{
    const History history = historyOf(contents);
    QJsonArray commands;
    for (const HistoryRow& row : history.rows()) {
        const QByteArray before =
            row.parent == 0 ? hashOfBeginning() : history.row(row.parent).stateHash;
        commands.append(QJsonObject{
            {QStringLiteral("seq"), qint64(row.id)},
            {QStringLiteral("parent"), qint64(row.parent)},
            {QStringLiteral("name"), row.name},
            {QStringLiteral("at"), told(row, row.origin.at.toUTC().toString(Qt::ISODateWithMs))},
            {QStringLiteral("author"), told(row, row.origin.author)},
            {QStringLiteral("program"), told(row, row.origin.program)},
            {QStringLiteral("edit"), editToJson(row.edit)},
            {QStringLiteral("voxels"), qint64(row.statistics.voxelsChanged)},
            {QStringLiteral("bytes"), qint64(row.deltaBytes)},
            {QStringLiteral("hashBefore"), hashValue(before)},
            {QStringLiteral("hashAfter"), hashValue(row.stateHash)},
        });
    }
    QJsonArray branches;
    for (const HistoryBranch& branch : branchesOf(history)) {
        QJsonArray seqs;
        for (const RowId id : branch.rows)
            seqs.append(qint64(id));
        branches.append(QJsonObject{
            {QStringLiteral("tip"), qint64(branch.tip)},
            {QStringLiteral("forksAt"), qint64(branch.forksAt)},
            {QStringLiteral("seqs"), seqs},
            {QStringLiteral("current"), branch.current},
        });
    }
    return {
        {QStringLiteral("problems"), QJsonArray::fromStringList(problems)},
        {QStringLiteral("position"), qint64(contents.position)},
        {QStringLiteral("source"),
            QJsonObject{
                {QStringLiteral("studyUid"), contents.source.studyUid},
                {QStringLiteral("seriesUid"), contents.source.seriesUid},
                {QStringLiteral("voxelsSha256"), QString::fromLatin1(contents.source.voxelsSha256)},
            }},
        {QStringLiteral("commands"), commands},
        {QStringLiteral("branches"), branches},
    };
}

QJsonObject historyAsRecipe(const SessionContents& contents)
{
    const History history = historyOf(contents);
    QJsonArray edits;
    std::map<RowId, RowId> numbers;
    for (const RowId id : history.pathTo(contents.position)) {
        edits.append(editToJson(asFirstGiven(renumbered(history.row(id).edit, numbers))));
        numbers.emplace(id, RowId(numbers.size()) + 1);
    }
    return {
        {QStringLiteral("study"), contents.source.toJson()},
        {QStringLiteral("edits"), edits},
    };
}

Edit renumbered(const Edit& edit, const std::map<RowId, RowId>& numbers)
{
    Edit result = edit;
    changeRowsNamed(result, [&numbers](RowId& row) {
        if (const auto number = numbers.find(row); number != numbers.end())
            row = number->second;
    });
    return result;
}

} // namespace core
