#include "report_patient.hpp"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <stdexcept>

#include "commands.hpp"
#include "report_words.hpp"

namespace mien::cli {
namespace {

/// Fields in the order of the file, which a patient's page keeps.
nlohmann::ordered_json read_fields(const std::string& path) {
    std::ifstream in(std::filesystem::u8path(path), std::ios::binary);
    if (!in) throw std::runtime_error(path + ": cannot be opened for reading");
    nlohmann::ordered_json file;
    try {
        file = nlohmann::ordered_json::parse(in);
    } catch (const nlohmann::json::exception& failure) {
        throw std::runtime_error(path + ": is not JSON (" + failure.what() + ")");
    }
    if (!file.is_object())
        throw std::runtime_error(path + ": expected {\"name\": \"...\", ...}, fields and values");
    return file;
}

std::string text_of(const std::string& path, const std::string& key,
                    const nlohmann::ordered_json& value) {
    if (value.is_string()) return value.get<std::string>();
    if (value.is_number() || value.is_boolean()) return value.dump();
    throw std::runtime_error(path + ": \"" + key + "\" is neither text nor a number");
}

bool all_digits(const std::string& text, std::size_t at, std::size_t count) {
    if (at + count > text.size()) return false;
    return std::all_of(text.begin() + static_cast<std::ptrdiff_t>(at),
                       text.begin() + static_cast<std::ptrdiff_t>(at + count),
                       [](char c) { return c >= '0' && c <= '9'; });
}

bool is_leap(long year) {
    return (year % 4 == 0 && year % 100 != 0) || year % 400 == 0;
}

int days_of_month(long year, int month) {
    static constexpr int kDays[] = {31, 28, 31, 30, 31, 30, 31, 31, 30, 31, 30, 31};
    return month == 2 && is_leap(year) ? 29 : kDays[month - 1];
}

}  // namespace

ReportFields read_patient(const std::string& path) {
    ReportFields fields;
    const nlohmann::ordered_json file = read_fields(path);
    for (const auto& [key, value] : file.items())
        fields.emplace_back(key, text_of(path, key, value));
    return fields;
}

VisitFile read_visit(const std::string& path) {
    VisitFile visit;
    const nlohmann::ordered_json file = read_fields(path);
    for (const auto& [key, value] : file.items()) {
        const std::string text = text_of(path, key, value);
        if (key == "date")
            visit.date = text;
        else if (key == "label")
            visit.label = text;
        else if (key == "scan")
            visit.scan =
                (std::filesystem::u8path(path).parent_path() / std::filesystem::u8path(text))
                    .u8string();
        else
            visit.fields.emplace_back(key, text);
    }
    if (!visit.date.empty() && !day_number(visit.date))
        throw std::runtime_error(path + ": \"date\" is \"" + valid_utf8(visit.date) +
                                 "\", which is no day of the form YYYY-MM-DD");
    return visit;
}

std::pair<std::string, std::string> date_of_name(const std::string& name) {
    const auto rest = [&](std::size_t at) {
        const std::size_t begin = name.find_first_not_of(" _-", at);
        return begin == std::string::npos ? std::string() : name.substr(begin);
    };
    if (all_digits(name, 0, 4) && name.size() >= 10 && name[4] == '-' && all_digits(name, 5, 2) &&
        name[7] == '-' && all_digits(name, 8, 2) && !all_digits(name, 10, 1) &&
        day_number(name.substr(0, 10)))
        return {name.substr(0, 10), rest(10)};
    if (all_digits(name, 0, 8) && !all_digits(name, 8, 1)) {
        const std::string date =
            name.substr(0, 4) + "-" + name.substr(4, 2) + "-" + name.substr(6, 2);
        if (day_number(date)) return {date, rest(8)};
    }
    return {"", name};
}

std::optional<long> day_number(const std::string& date) {
    if (date.size() != 10 || date[4] != '-' || date[7] != '-' || !all_digits(date, 0, 4) ||
        !all_digits(date, 5, 2) || !all_digits(date, 8, 2))
        return std::nullopt;
    const long year = std::stol(date.substr(0, 4));
    const int month = std::stoi(date.substr(5, 2)), day = std::stoi(date.substr(8, 2));
    if (year < 1900 || month < 1 || month > 12 || day < 1 || day > days_of_month(year, month))
        return std::nullopt;
    long number = day - 1;
    for (long y = 1970; y < year; ++y) number += is_leap(y) ? 366 : 365;
    for (long y = year; y < 1970; ++y) number -= is_leap(y) ? 366 : 365;
    for (int m = 1; m < month; ++m) number += days_of_month(year, m);
    return number;
}

std::string date_text(long day) {
    long year = 1970;
    while (day < 0) day += is_leap(--year) ? 366 : 365;
    while (day >= (is_leap(year) ? 366 : 365)) day -= is_leap(year++) ? 366 : 365;
    int month = 1;
    while (day >= days_of_month(year, month)) day -= days_of_month(year, month++);
    char text[32];
    std::snprintf(text, sizeof text, "%04ld-%02d-%02ld", year, month, day + 1);
    return text;
}

}  // namespace mien::cli
