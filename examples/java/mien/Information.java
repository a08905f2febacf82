package mien;

// Written by abi/generate_bindings.py.
/** What belongs to no object. */
public final class Information {
    private Information() {}

    /**
     * The name of a status, e.g. "MIEN_E_IO". C: mien_status_name().
     * @param status any value; unknown ones give "MIEN_E_UNKNOWN".
     */
    public static String statusName(int status) {
        return Call.text(Raw.GET.mien_status_name(status));
    }

    /** The library's version as MAJOR * 1000000 + MINOR * 1000 + PATCH. C: mien_version_number(). */
    public static int versionNumber() {
        return Raw.GET.mien_version_number();
    }

    /** The library's version as text, e.g. "0.2.0". C: mien_version_string(). */
    public static String versionString() {
        return Call.text(Raw.GET.mien_version_string());
    }

    /**
     * What was built, for bug reports: version, compiler, instruction sets in use on this processor. C:
     * mien_build_id().
     */
    public static String buildId() {
        return Call.text(Raw.GET.mien_build_id());
    }
}
