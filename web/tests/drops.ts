// A file dropped onto the page, as bytes or as text.
import type { Page } from '@playwright/test';

export async function dropOn(page: Page, where: string, name: string, content: string | number[]): Promise<void> {
  const data = await page.evaluateHandle(
    ([name, content]) => {
      const data = new DataTransfer();
      data.items.add(new File([typeof content === 'string' ? content : new Uint8Array(content)], name));
      return data;
    },
    [name, content] as const,
  );
  await page.dispatchEvent(where, 'drop', { dataTransfer: data });
}
