#pragma once

// Why something is not accepted: the place in the file and the reason.

#include <stdexcept>
#include <string>

namespace gcslab::verifier {

class Refused : public std::runtime_error {
 public:
  Refused(std::string where, const std::string& reason)
      : std::runtime_error(reason), where_(std::move(where)) {}
  const std::string& where() const { return where_; }

 private:
  std::string where_;
};

}  // namespace gcslab::verifier
