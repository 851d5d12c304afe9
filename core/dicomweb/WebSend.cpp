// SPDX-License-Identifier: Apache-2.0
#include "core/dicomweb/WebSend.h"

#include "core/dicomweb/JsonSink.h"
#include "core/dicomweb/WebConnection.h"
#include "core/pacs/NodeStatus.h"
#include "core/pacs/retrieve/DownloadFolder.h"

#include <QFileInfo>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

#include <algorithm>
#include <cstdint>
#include <optional>

namespace core {

namespace {

/// The first reason of a list in a STOW-RS answer (PS3.18 10.5.3); none: it is not there.
std::optional<std::uint16_t> reasonIn(
    const QJsonObject& answer, const char* list, const char* reasonTag)
{
    const QJsonArray items = answer[QLatin1String(list)].toObject()[u"Value"].toArray();
    for (const QJsonValue& item : items) {
        const QJsonArray reasons =
            item.toObject()[QLatin1String(reasonTag)].toObject()[u"Value"].toArray();
        if (!reasons.isEmpty())
            return std::uint16_t(reasons.first().toInt());
    }
    return items.isEmpty() || QLatin1String(reasonTag) != QLatin1String("00081197")
        ? std::nullopt
        : std::optional<std::uint16_t>(0x0110);
}

/// The object of a STOW-RS answer in JSON; some servers put it into a list.
QJsonObject objectIn(const QByteArray& bytes)
{
    const QJsonDocument document = QJsonDocument::fromJson(bytes);
    return document.isArray() ? document.array().at(0).toObject() : document.object();
}

/// Whether an item of the list of stored objects is this one; one without a name is believed.
bool mayName(const QJsonObject& item, const QString& sopInstanceUid)
{
    const QJsonArray names = item[u"00081155"].toObject()[u"Value"].toArray();
    return names.isEmpty() || names.first().toString().trimmed() == sopInstanceUid;
}

/// Whether an answer of success tells that the object was stored. One that is empty, or in XML, is
/// believed.
Result<void> checkStored(const WebNode& node, const Clause& what, const WebAnswer& answer,
    const QByteArray& bytes, const QJsonObject& told, const QString& sopInstanceUid)
{
    const QByteArray type = answer.contentType.toLower();
    if (bytes.trimmed().isEmpty())
        return {};
    const bool isJson = type.contains("json");
    const bool isXml = type.contains("xml") && !type.contains("html");
    if (!isJson && !isXml) {
        return failure(ErrorCode::NodeNonsense, node.name(),
            Clause::saying("it answers with '%1' where DICOM JSON was asked for",
                QString::fromLatin1(answer.contentType.left(60))));
    }
    if (isXml)
        return {};
    const QJsonArray stored = told[u"00081199"].toObject()[u"Value"].toArray();
    if (stored.isEmpty()) {
        return failure(ErrorCode::NodeFailed, node.name(), what,
            Clause::saying("its answer names nothing that it stored"));
    }
    const bool isNamed = std::any_of(stored.begin(), stored.end(),
        [&](const QJsonValue& item) { return mayName(item.toObject(), sopInstanceUid); });
    if (!isNamed) {
        return failure(ErrorCode::NodeFailed, node.name(), what,
            Clause::saying("its answer names another object as stored"));
    }
    return {};
}

} // namespace

Result<SentObjects> sendFiles(
    const WebNode& node, const QStringList& files, const Progress& progress)
{
    QStringList uids;
    for (const QString& file : files) {
        const Result<QString> uid = soundObject(file);
        if (!uid)
            return tl::unexpected<Error>(uid.error());
        uids.append(*uid);
    }
    SentObjects result;
    if (files.isEmpty())
        return result;
    Result<WebConnection> connection = WebConnection::open(node, progress);
    if (!connection)
        return tl::unexpected<Error>(connection.error());
    for (qsizetype i = 0; i < files.size(); ++i) {
        const QString& file = files[i];
        const QString name = QFileInfo(file).fileName();
        const Clause what = Clause::saying("the storage of %1", name);
        JsonSink sink(node.name(), true);
        const Result<WebAnswer> answer = connection->postFile("/studies", file, what, sink);
        if (!answer)
            return tl::unexpected<Error>(answer.error());
        const QJsonObject told = objectIn(sink.bytes());
        const auto failed = reasonIn(told, "00081198", "00081197");
        if (failed || answer->status == 409) {
            return failure(
                ErrorCode::NodeFailed, node.name(), what, statusText(failed.value_or(0x0110)));
        }
        const Result<void> stored = checkStored(node, what, *answer, sink.bytes(), told, uids[i]);
        if (!stored)
            return tl::unexpected<Error>(stored.error());
        if (const auto warned = reasonIn(told, "00081199", "00081196"))
            result.warnings.append(QStringLiteral("%1: %2").arg(name, statusText(*warned)));
        ++result.sent;
        progress.report(ProgressStep::Sending, result.sent, int(files.size()));
    }
    return result;
}

} // namespace core
