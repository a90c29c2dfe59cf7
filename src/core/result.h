// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <expected>
#include <string>

namespace agv {

/// What kind of thing went wrong; the text in Error::detail says what exactly, where, and what to do.
enum class ErrorCode {
    BadInput,   ///< a file, line or argument breaks its format
    NotFound,   ///< a file, tag, robot or address does not exist
    Permission, ///< the system forbids the access
    InUse,      ///< a port or file is held by another program
    Network,    ///< a connection could not be made or was lost
    Io,         ///< reading or writing a file failed
    Cancelled,  ///< the caller asked to stop
    NoSolution, ///< the input is well formed but does not determine an answer
};

struct Error {
    ErrorCode code = ErrorCode::BadInput;
    std::string detail; ///< plain English for logs and the terminal: what, where, what to do
};

/// Value or error; the only way a function of this program reports a failure the caller must handle.
template<typename T>
using Result = std::expected<T, Error>;

inline std::unexpected<Error> failure(ErrorCode code, std::string detail)
{
    return std::unexpected(Error{code, std::move(detail)});
}

} // namespace agv
