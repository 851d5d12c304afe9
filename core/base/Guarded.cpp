// SPDX-License-Identifier: Apache-2.0
#include "core/base/Guarded.h"

#include "core/base/MemoryReserve.h"

#include <exception>
#include <new>
#include <system_error>

namespace core {

namespace {

constexpr std::size_t worthNaming = std::size_t(64) << 10;

QString megabytes(std::size_t bytes)
{
    return QString::number(double(bytes) * 1e-6, 'f', bytes < 10'000'000 ? 2 : 0);
}

Clause whatWasNeeded(std::size_t bytes)
{
    if (bytes < worthNaming)
        return Clause::saying("the program may not take more of the main memory");
    return Clause::saying("%1 MB more are needed, and the program, which has taken %2 MB, may not "
                          "take that much",
        megabytes(bytes), megabytes(addressSpaceBytes()));
}

Error thrownError()
{
    try {
        throw;
    } catch (const MemoryRefused& refusal) {
        giveUpMemoryReserve();
        return {ErrorCode::OutOfMemory, {whatWasNeeded(refusal.bytes())}};
    } catch (const std::bad_alloc&) {
        giveUpMemoryReserve();
        return {ErrorCode::OutOfMemory, {whatWasNeeded(0)}};
    } catch (const std::system_error& failure) {
        if (failure.code() == std::errc::resource_unavailable_try_again)
            return {ErrorCode::OutOfMemory, {Clause::saying("no further thread can be started")}};
        return {ErrorCode::Internal, {QString::fromUtf8(failure.what())}};
    } catch (const std::exception& failure) {
        return {ErrorCode::Internal, {QString::fromUtf8(failure.what())}};
    } catch (...) {
        return {ErrorCode::Internal, {Clause::saying("something was thrown")}};
    }
}

} // namespace

Error errorBeingHandled() noexcept
{
    try {
        return thrownError();
    } catch (...) { // not even memory to say so
        return {ErrorCode::OutOfMemory, {}};
    }
}

} // namespace core
