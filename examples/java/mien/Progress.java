package mien;

/** Called on the calling thread; false cancels. What it throws comes out of the call that was running. */
@FunctionalInterface
public interface Progress {
    boolean report(int stage, double fraction);
}
